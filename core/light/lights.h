// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/mat3.h"

namespace etak {

/// A discrete light. Space of the scene: object at the origin with radius 1, +z towards the camera, +y up.
///   point         color * intensity is radiant intensity, W/sr; arrives as intensity / r^2, with r at least
///                 point_light_min_r
///   directional   color * intensity is irradiance on a plane facing the light, W/m^2, the same everywhere
///   spot          a point light with a cone: full inside inner_deg, nothing outside outer_deg (half-angles)
enum class LightKind { point, directional, spot };
inline constexpr double point_light_min_r = 1e-3;
std::string_view name(LightKind kind);
std::optional<LightKind> light_kind_named(std::string_view text);

struct Light {
  LightKind kind = LightKind::directional;
  Vec3 position{0, 0, 0};                 // point, spot
  Vec3 direction{0, 0, -1};               // directional, spot: the way the light travels; unit length
  Vec3 color{1, 1, 1};                    // linear RGB, >= 0
  double intensity = 1;                   // >= 0
  double inner_deg = 20, outer_deg = 30;  // spot: 0 <= inner <= outer <= 90
  friend bool operator==(const Light&, const Light&) = default;
};

/// Schueler's second light model: constant radiance from the half space around `axis` and from its opposite.
enum class HemisphereForm { corrected, wide, printed };
std::string_view name(HemisphereForm form);
std::optional<HemisphereForm> hemisphere_form_named(std::string_view text);

struct Hemispheres {
  Vec3 upper{0.6, 0.7, 0.8}, lower{0.25, 0.22, 0.2};  // radiance, linear RGB, >= 0
  Vec3 axis{0, 1, 0};                                 // unit length
  HemisphereForm form = HemisphereForm::corrected;
  friend bool operator==(const Hemispheres&, const Hemispheres&) = default;
};

/// All light on a scene. Intensities are radiometric; with `pi_scaled` the irradiances are Schueler's E / pi,
/// so that a white Lambert surface lit head-on with 1 shows 1.
struct LightSetup {
  std::vector<Light> lights;
  std::optional<Hemispheres> hemispheres;
  std::string environment;  // file of a lat-long HDR image, or a name of core/light/studio.h; empty: none
  double environment_scale = 1;
  bool pi_scaled = false;
  friend bool operator==(const LightSetup&, const LightSetup&) = default;
};

/// The unit vector to a place above the horizon and to the right of the camera, as the object sees them: 0, 0
/// is the camera's own direction, +z.
Vec3 direction_of_angles(double elevation_deg, double azimuth_deg);

/// `v` with length 1; straight away from the viewer where it has none.
Vec3 normalised_direction(const Vec3& v);

/// Throws Error (naming `what`) for negative, NaN or infinite numbers, zero-length directions, inner > outer
/// cone.
void validate(const LightSetup& setup, std::string_view what);

/// Reads a light setup (resources/schema/lights.schema.json). Throws Error with file and JSON pointer.
LightSetup parse_lights(std::string_view text, std::string_view file);

/// A light setup as parse_lights() reads it, without line break at its end; numbers read back equal.
///   indent   blanks before the closing brace
std::string format_lights(const LightSetup& setup, int indent = 0);

/// Three directional lights (key, fill, rim) and two hemispheres: light as the sources have it. Pictures are
/// made with studio_lights() (core/light/studio.h) when nothing is said.
LightSetup default_lights();

/// Sets the environment, empty for none. One takes the place of the hemispheres, which stand for the same
/// light.
void choose_environment(LightSetup& setup, const std::string& environment);

/// `count` directional lights of white, spread over the half space before the object.
std::vector<Light> spread_lights(int count);

}  // namespace etak
