// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// What a parameter of a term or model stands for. Materials, sliders and random tests choose its value by
/// this.
enum class Role {
  diffuse,  // diffuse colour or albedo, per channel
  f0,       // specular reflectance at normal incidence, per channel
  f82,      // reflectance at cos 1/7, per channel: absolute, or a tint where the name says so
  n,
  k,         // complex index, per channel
  curve,     // F over the angle, a colour of several: core/fresnel/curve.glsl
  gloss,     // Schueler's g
  alpha,     // width of GGX or Beckmann (m)
  exponent,  // of Phong-like lobes
  other
};

/// A parameter. Where `color` is set it takes three numbers (red, green, blue), else one. The range is what a
/// slider offers, and typed values must lie in it. Measured colours outside of it (gold's red F0 of 1.022, or
/// -0.01 for a colour out of gamut) are evaluated all the same: F is then what its curve gives, above 1 at
/// normal incidence and falling to 1 at grazing, but nowhere below 0. Where an index is computed from F0
/// (Gulbrandsen, exact from F0), and in Schueler's bounded Optimized, the reflectance is kept at or below 1.
/// Every model stays finite and at or above 0.
struct Parameter {
  std::string_view name;  // as in formulas, options and files: "K", "g", "alpha"
  std::string_view meaning;
  std::string_view unit;  // "" for pure numbers
  double min, max, initial;
  Role role;
  bool color;
};

/// The directions to the light (l) and to the viewer (v): unit vectors that point away from the surface, in
/// its frame with normal +z and tangent +x.
struct Directions {
  double lx, ly, lz, vx, vy, vz;
};

/// The kinds of terms that a microfacet model is made of: f = D F V with V = G / (4 nl nv).
enum class TermKind { distribution, fresnel, visibility };
std::string_view name(TermKind kind);  // "D", "F", "V"

/// What a model claims. Tests check each claim, and must find a counter-example where a model does not make
/// it.
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

/// A row of the registry: everything that programs, editors, reports and tests know about a model. Rows are
/// made in models.cpp only and live as long as the program.
struct Model {
  std::string_view id;  // "schueler-optimized-bounded"
  std::string_view title;
  std::string_view source;  // article and equation; "as printed" where a known error of the article is kept
  ModelKind kind = ModelKind::specular;
  Claims claims;
  std::span<const Parameter> parameters;
  std::span<const Parameter> derived;       // numbers that the entry takes after the parameters: see derive()
  std::span<const std::string_view> files;  // GLSL texts in order of use: "brdf/schueler.glsl"
  std::string_view entry;                   // vec3 entry(Angles a, parameters in order, derived in order)
  std::string_view text;  // GLSL of the entry, for models made of terms; empty where a file has it
  // The terms that the model is made of; null for models with a text of their own.
  const Term *distribution = nullptr, *fresnel = nullptr, *visibility = nullptr;
  bool compensated() const;  // light that facets reflect to each other is added: see Term::compensated

  /// f_r in 1/sr, per channel, in double. It is 0 unless both directions are above the surface and l is not
  /// -v.
  ///   values   value_count() numbers: the parameters in order, three numbers for each colour
  void f64(const Directions& d, const double* values, double rgb[3]) const;

  /// f_r in float, with the functions of the C library.
  void f32(const Directions& d, const double* values, float rgb[3]) const;

  /// f_r in float for `count` pairs of directions at once, by vector instructions.
  ///   directions   arrays of x, y and z of l, then of x, y and z of v
  ///   rgb          arrays for the results, one for each channel
  ///   error        relative to f32(): 1e-6 for algebraic models, 2e-5 where powers and exponentials are
  ///                computed (by polynomials instead of the C library)
  void f32_batch(std::size_t count, const float* const directions[6], const double* values,
                 float* const rgb[3]) const;

  /// f_r for a light and a viewer at infinity, whose directions are the same for all points while the
  /// surface's frame differs. F depends on these two directions alone and is computed once. Call it only
  /// where has_far_loop() is true, as it is for every model of models().
  ///   lh       cosine between half vector and light
  ///   turned   arrays of nl, nv, and the half vector's tangent, bitangent and normal components
  void f32_batch_far(std::size_t count, double lh, const float* const turned[5], const double* values,
                     float* const rgb[3]) const;
  bool has_far_loop() const;

  std::size_t value_count() const;    // how many numbers `values` holds
  std::size_t derived_count() const;  // how many numbers derive() writes

  /// Computes the numbers of `derived` from the parameters: constants, such as that of ABC, that are too
  /// expensive for a GPU to compute at each pixel.
  void derive(const double* values, double* out) const;
  bool derives_from_width() const;  // so that no texture can hold the width

  struct Compiled;
  const Compiled* compiled = nullptr;
};

/// The models that have an id of their own, in the order of the documentation.
std::span<const Model> models();

/// The model with this id; null when there is none. An id "microfacet:D,F,V" gives the model of any three
/// terms, such as "microfacet:ggx,schlick,smith-ggx-height"; it is made when it is first asked for. "as-unreal" and
/// so on are those of engines (core/render/engines.h), which models() leaves out. Any thread may call this.
const Model* find_model(std::string_view id);

/// The models that are used when the user names none: Lambert, and Schueler's Optimized with bounded
/// reflectance.
inline constexpr std::string_view default_diffuse = "lambert",
                                  default_specular = "schueler-optimized-bounded";

/// A term: distribution D(a, ...), Fresnel F(..., lh) or visibility V(a, ...).
struct Term {
  std::string_view id, title, source;
  TermKind kind;
  std::span<const Parameter> parameters;
  std::span<const Parameter> derived;
  std::span<const std::string_view> files;
  // GLSL function, which takes (parameters, derived, nh, s2) for a distribution, (parameters, lh) for a
  // Fresnel term and (a, parameters) for a visibility.
  std::string_view entry;
  std::string_view note;   // a known property: "integral 1", "as printed: integral pi / 4"
  bool normalised = true;  // distribution: the integral of D nm is 1
  // Visibility: light that facets reflect to each other is added. The entry returns the vec3 V of brdf_compensated().
  bool compensated = false;

  /// The term's value in double. A distribution or visibility gives the same number for all three channels, except for a
  /// compensated one, which gives the numbers of its vec3.
  void f64(const Directions& d, const double* values, double rgb[3]) const;
};
std::span<const Term> terms();
const Term* find_term(TermKind kind, std::string_view id);

/// How many numbers the parameters take together.
std::size_t number_count(std::span<const Parameter> parameters);

/// The instruction set that f32_batch() uses on this processor: "x86-64-v4", "x86-64-v3" or "generic".
std::string_view batch_instruction_set();

}  // namespace etak
