// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// What a parameter of a term or model is for: how a material, a slider or a random test fills it.
enum class Role {
  diffuse,  // diffuse colour or albedo, per channel
  f0,       // specular reflectance at normal incidence, per channel
  f82,      // reflectance at cos 1/7, per channel (absolute or as tint: see the name)
  n,
  k,         // complex index, per channel
  gloss,     // Schueler's g
  alpha,     // width of GGX or Beckmann (m)
  exponent,  // of Phong-like lobes
  other
};

/// A parameter: `color` ones take three numbers (red, green, blue), the others one. The range is what a
/// slider offers and what typed values are held to; measured colours beyond it (gold's red F0 of 1.022, -0.01
/// out of gamut) are evaluated: F is then what its curve gives, above 1 at normal incidence and falling to 1
/// at grazing, but nowhere below 0. Where an index is made of F0 (Gulbrandsen, exact from F0) and in
/// Schueler's bounded Optimized the reflectance is kept at or below 1. Every model stays finite and at or
/// above 0.
struct Parameter {
  std::string_view name;  // as in EVAL and in files: "K", "g", "alpha"
  std::string_view meaning;
  std::string_view unit;  // "" for pure numbers
  double min, max, initial;
  Role role;
  bool color;
};

/// Two directions in the frame of the surface: normal +z, tangent +x; unit vectors, away from the surface.
struct Directions {
  double lx, ly, lz, vx, vy, vz;
};

/// Kinds of terms from which a microfacet model is put together: f = D F V with V = G / (4 nl nv).
enum class TermKind { distribution, fresnel, visibility };
std::string_view name(TermKind kind);  // "D", "F", "V"

/// What a model claims; tests hold it to that, and look for a counter-example where it claims not.
struct Claims {
  bool reciprocal = true;
  bool conserves_energy = true;
  std::string_view note = {};  // "albedo 1.075 at m = 8.8, normal incidence"
};

enum class ModelKind {
  diffuse,   // the matte part alone
  specular,  // the mirror-like part alone
  combined   // one formula for both
};
std::string_view name(ModelKind kind);  // "diffuse", "specular", "both"

struct Term;

/// A row of the registry: all that programs, editors, reports and tests know of a model. Made in models.cpp
/// only; lives as long as the program.
struct Model {
  std::string_view id;  // "schueler-optimized-bounded"
  std::string_view title;
  std::string_view
      source;  // article and equation; "as printed" where the print is kept against better knowledge
  ModelKind kind = ModelKind::specular;
  Claims claims;
  std::span<const Parameter> parameters;
  std::span<const Parameter>
      derived;  // numbers the entry takes behind its parameters, computed from them: derive()
  std::span<const std::string_view> files;  // GLSL texts in order of use: "brdf/schueler.glsl"
  std::string_view entry;                   // vec3 entry(Angles a, parameters in order, derived in order)
  std::string_view
      text;  // GLSL of the entry when it is in no file: microfacet models made of terms; else empty
  const Term *distribution = nullptr, *fresnel = nullptr,
             *visibility = nullptr;  // of which it is made, or null

  /// f_r in 1/sr, per channel. `values` holds the parameters one behind the other, three numbers for a color
  /// one. Zero unless both directions are above the surface and l is not -v.
  void f64(const Directions& d, const double* values, double rgb[3]) const;

  /// The same text in float, with the C library's functions.
  void f32(const Directions& d, const double* values, float rgb[3]) const;

  /// `count` directions at once, f32 in vector lanes; the arrays hold x, y, z of l, then of v, one array
  /// each. Within 1e-6 of f32 for algebraic models, 2e-5 for powers and exponentials (polynomials in place of
  /// the C library).
  void f32_batch(std::size_t count, const float* const directions[6], const double* values,
                 float* const rgb[3]) const;

  /// The same for a light and a viewer far away, before whom only the surface turns: what they alone decide,
  /// all of F, is computed once. `turned` holds arrays of nl, nv and of the half vector's tangent, bitangent
  /// and normal parts; `lh` is its cosine with the light. Call only where has_far_loop() says so: every model
  /// with a name of its own.
  void f32_batch_far(std::size_t count, double lh, const float* const turned[5], const double* values,
                     float* const rgb[3]) const;
  bool has_far_loop() const;

  std::size_t value_count() const;    // numbers in `values`
  std::size_t derived_count() const;  // numbers derive() writes

  /// The numbers of `derived`: ABC's constant, for one, which no GPU should compute per pixel.
  void derive(const double* values, double* out) const;

  struct Compiled;
  const Compiled* compiled = nullptr;
};

/// The models with names of their own, in the order of the documentation.
std::span<const Model> models();

/// A model by its id, or "microfacet:D,F,V" for any three terms ("microfacet:ggx,schlick,smith-ggx-height"),
/// made when first asked for; null when there is none. Any thread may call.
const Model* find_model(std::string_view id);

/// What to take when nothing is said: Lambert, and Schueler's Optimized with its reflectance bounded.
inline constexpr std::string_view default_diffuse = "lambert",
                                  default_specular = "schueler-optimized-bounded";

/// A term: distribution D(a, ...), Fresnel F(..., lh) or visibility V(a, ...).
struct Term {
  std::string_view id, title, source;
  TermKind kind;
  std::span<const Parameter> parameters;
  std::span<const Parameter> derived;
  std::span<const std::string_view> files;
  std::string_view entry;  // distribution: (parameters, derived, nh, s2); fresnel: (parameters, lh);
                           // visibility: (a, parameters)
  std::string_view note;   // what it is known for: "integral 1", "as printed: integral pi / 4"
  bool normalised = true;  // distribution: the integral of D nm is 1

  void f64(const Directions& d, const double* values, double rgb[3]) const;  // D and V: the same in all three
};
std::span<const Term> terms();
const Term* find_term(TermKind kind, std::string_view id);

/// Numbers that `parameters` take together.
std::size_t number_count(std::span<const Parameter> parameters);

/// Instruction set of f32_batch on this processor: "x86-64-v4", "x86-64-v3" or "generic".
std::string_view batch_instruction_set();

}  // namespace etak
