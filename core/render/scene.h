// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/brdf/models.h"
#include "core/color/gloss.h"
#include "core/image/image.h"
#include "core/light/lights.h"
#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// What is known of the surface, per channel in linear sRGB: models take from it what their parameters' roles
/// ask for.
struct SurfaceValues {
  Vec3 diffuse{0, 0, 0};
  Vec3 f0{0.04, 0.04, 0.04};
  Vec3 f82{1, 1, 1};                  // absolute reflectance at cos 1/7
  Vec3 n{1.5, 1.5, 1.5}, k{0, 0, 0};  // RGB n, k: solved from F0 and F82 per channel
  Gloss gloss = 0.75;  // Schueler's g: e = 2^(12 g), alpha = m = sqrt(2 / (e + 2)); or, where a
                       // perceptual roughness was given, alpha = roughness^2 and the nearest g
  double opacity = 1;  // alpha of the body
  std::optional<OpticalConstants> optics;  // for the spectral reference; none: n, k as given
  Vec3 nk_residual{
      0, 0, 0};  // how far F0 or F82 of n, k are from f0, f82 (F0 above 1 has no n, k): larger of the two
  friend bool operator==(const SurfaceValues&, const SurfaceValues&) = default;
};

/// Surface of a library material: F0, F82 and RGB n, k from its spectrum; diffuse black for conductors and
/// semiconductors, `diffuse` for the rest. `surface` class materials give the diffuse colour that adds up
/// with an F0 of 0.04 to what was measured, and a lower F0 where the body is darker than that (divided() in
/// core/material/appearance.h).
SurfaceValues surface_of(const Material& material, const Dataset& dataset, const Vec3& diffuse,
                         const Gloss& gloss);

/// The same from a result that was computed under other options (another outside medium, illuminant or
/// observer): its linear sRGB and F82 as they are. Throws Error for a refused one.
///   f0   of `dataset`, with linear sRGB as output space
SurfaceValues surface_of(const Material& material, const Dataset& dataset, const F0Result& f0,
                         const Vec3& diffuse, const Gloss& gloss);

/// Completes a surface of which only f0 (and the plain numbers) is known: F82 and n, k of the dielectric with
/// that F0 below the forbidden zone; above it Schlick's F82, and n, k of a metal.
void complete_from_f0(SurfaceValues& surface);

/// Sets n, k of `surface` to those that give its f0 and f82, and nk_residual to what is missed.
///   log_n_hints   where two n give both, the one with the logarithm nearest to this is taken
void solve_index(SurfaceValues& surface, const Vec3& log_n_hints);

/// A value of a surface that a model's range does not hold.
struct ClampedValue {
  std::string name;  // "K.r"
  double wanted, used;
};

/// Fills a model's parameters by role, then by name from `overrides` ("m", 0.3; three entries "K.r", "K.g",
/// "K.b" or one "K" for all). Throws Error for unknown names and overrides outside a parameter's range.
///   clamped   when given, gets the values of `surface` that were brought into range; F0 and diffuse colours
///             may stay outside their range (gold's red in sRGB is above 1)
std::vector<double> model_values(const Model& model, const SurfaceValues& surface,
                                 const std::vector<std::pair<std::string, double>>& overrides,
                                 std::vector<ClampedValue>* clamped = nullptr);

/// Whether the model has diffuse parameters and all their values are 0: it then gives no diffuse light.
bool body_is_black(const Model& model, const std::vector<double>& values);

/// The models of a surface with their values, as a scene or a viewport takes them.
struct FittedModels {
  const Model *specular = nullptr, *diffuse = nullptr;
  std::vector<double> specular_values, diffuse_values;
  std::vector<ClampedValue> clamped;
};

/// Fills both models from `surface`, then by name from `overrides`: a name goes to the specular model where
/// that has it, else to the diffuse one. Where something was overridden, hemispheres and environment see it
/// too: the colours and gloss of `surface` become those of the models. A specular model of kind both takes no
/// diffuse one beside it. Throws Error for models of the wrong kind and for overrides that none of them has.
FittedModels fit_models(const Model* specular, const Model* diffuse,
                        const std::vector<std::pair<std::string, double>>& overrides, SurfaceValues& surface);

/// Where the camera stands, and what of its picture is shown.
struct View {
  double turn_deg = 0;          // around y; at 90 the camera looks from +x
  double rise_deg = 0;          // above the horizon, -90 to 90
  double pan_x = 0, pan_y = 0;  // of the picture's middle, in radii of the sphere
  double zoom = 1;              // above 0
  friend bool operator==(const View&, const View&) = default;
};

/// A texture pair: what varies over a surface, both with four channels in linear light. Looked up bilinearly,
/// edges repeated; on the quad from its left upper corner, on the sphere lat-long with its seam behind.
struct SurfaceTextures {
  Image body;   // diffuse colour and opacity
  Image gloss;  // F0 and gloss
};

enum class Shape { sphere, quad };
enum class Transfer { srgb, power_045, square_root, linear };
/// What is done to exposed light before the transfer: core/light/tone.glsl.
enum class Tone { plain, neutral, agx_like };

/// A picture's contents: one object, its models, the light, the camera. Same for CPU and GL:
///   pixel         (i, j) with rows from the top lies at x = (i + 1/2 - width/2) s,
///                 y = (height/2 - j - 1/2) s, with s = 2.2 / height
///   camera        orthographic: looks along -z, viewer direction +z. Perspective: at (0, 0, d) with
///                 d^2 = 1 + (1.1 / tan(fov/2))^2, so that the silhouette keeps its radius of 1 at x, y
///   sphere        coverage of a pixel = clamp(1/2 + (1 - r) / s, 0, 1), r^2 = x^2 + y^2; a pixel is shaded
///                 at its centre, moved inwards where that lies beyond r = 0.9999
///   quad          the square |x|, |y| <= 1 in the plane z = 0, normal +z; coverage = product of the sphere's
///                 expression for r = |x| and for r = |y|
///   frame         tangent t = normalize(cross(y, n)), the x axis where |cross|^2 < 1e-12; bitangent
///                 b = cross(n, t)
///   light         sum of f_r E nl, times pi where `pi_scaled`; hemispheres take diffuse, f0 and gloss of
///                 `surface`
///   opacity < 1   specular + opacity * diffuse + (1 - opacity)(1 - F(nv)) * background, where F is
///                 Schueler's of the luminance of surface.f0; specular is never multiplied by opacity
///   stripes       over the object, 6 pixels wide at 45 degrees, 0.6 of which is magenta (zone) or, slanted
///                 the other way, yellow (energy), as if lit so that they show under the exposure. With
///                 textures both are decided per pixel, and energy is diffuse colour plus F0 above 1
///   output        transfer(clamp to >= 0 of tone(exposure * mix(background, object, coverage))), alpha 1
struct Scene {
  Shape shape = Shape::sphere;
  SurfaceValues surface;
  const Model* specular = nullptr;  // may be of kind both; null: no specular part
  std::vector<double> specular_values;
  const Model* diffuse = nullptr;  // null: no diffuse part; always where `specular` is of kind both
  std::vector<double> diffuse_values;
  std::shared_ptr<const SurfaceTextures>
      textures;                    // in place of the surface's diffuse, opacity, f0 and gloss
  bool mark_zone = false;          // stripes where the luminance of F0 is in the forbidden zone
  std::vector<float> mark_energy;  // stripes where this (quick_albedo) is above 1; empty: none
  LightSetup lights;
  double environment_turn_deg = 0;  // around y
  std::optional<View> view;         // none: from the front, whole
  bool perspective = false;         // orthographic otherwise
  double field_of_view_deg = 30;    // perspective: vertical
  double exposure = 1;              // linear factor
  Tone tone = Tone::plain;
  Transfer transfer = Transfer::srgb;
  Vec3 background{0.18, 0.18, 0.18};  // linear
  int width = 512, height = 512;
};

/// The values of the specular model with the diffuse colour of one of kind `both` times the surface's
/// opacity: every model is linear in its diffuse colour, and the rest is never multiplied by opacity.
std::vector<double> seen_specular_values(const Scene& scene);

/// Throws Error for numbers out of their domain: sizes outside 1..16384, NaN, n <= 0, k < 0, parameter lists
/// that do not fit their models, a scene without any model, bad lights.
void validate(const Scene& scene);

}  // namespace etak
