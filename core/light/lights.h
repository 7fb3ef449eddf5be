// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/mat3.h"

namespace etak {

/// The kind of a discrete light. In the space of the scene, the object has radius 1 and lies at the origin,
/// +z points towards the camera and +y up.
///   point         color * intensity is radiant intensity in W/sr; at distance r the irradiance is
///                 intensity / r^2, with r at least point_light_min_r
///   directional   color * intensity is the irradiance on a plane that faces the light, in W/m^2, the same
///                 everywhere
///   spot          a point light with a cone: full inside the half-angle inner_deg, nothing outside outer_deg
///   rectangle     color * intensity is the radiance in W/(m^2 sr) of a rectangle that is lit on one side, to where
///                 `direction` shows; it is not seen itself
///   disc          the same for an ellipse, a disc where width and height are equal
enum class LightKind { point, directional, spot, rectangle, disc };
inline constexpr std::array light_kinds{LightKind::point, LightKind::directional, LightKind::spot,
                                        LightKind::rectangle, LightKind::disc};
inline constexpr double point_light_min_r = 1e-3;
std::string_view name(LightKind kind);
std::optional<LightKind> light_kind_named(std::string_view text);
constexpr bool is_area(LightKind kind) {
  return kind == LightKind::rectangle || kind == LightKind::disc;
}

/// One light of a scene.
struct Light {
  LightKind kind = LightKind::directional;
  Vec3 position{0, 0, 0};                 // all but directional; of areas their centre
  Vec3 direction{0, 0, -1};               // all but point: where the light goes; unit length
  Vec3 color{1, 1, 1};                    // linear RGB, >= 0
  double intensity = 1;                   // >= 0
  double inner_deg = 20, outer_deg = 30;  // spot: 0 <= inner <= outer <= 90
  double width = 1, height = 1;           // areas: sides or diameters, above 0
  Vec3 up{0, 1, 0};                       // areas: their height lies as near to it as they can; unit length
  friend bool operator==(const Light&, const Light&) = default;
};

/// The formula of the specular light of two hemispheres.
///   automatic   Schueler's for Schueler's models, else that of the model
///   model       the model's own albedo and lobe (core/light/ambient.glsl)
///   corrected   Schueler's, corrected (core/light/hemispheres.glsl)
///   wide        the same with a wider transition between the hemispheres
///   printed     as printed
enum class HemisphereForm { automatic, model, corrected, wide, printed };
inline constexpr std::array hemisphere_forms{HemisphereForm::automatic, HemisphereForm::model,
                                             HemisphereForm::corrected, HemisphereForm::wide,
                                             HemisphereForm::printed};
std::string_view name(HemisphereForm form);
std::optional<HemisphereForm> hemisphere_form_named(std::string_view text);

/// Schueler's second light model: one constant radiance from the half space around `axis`, another from the
/// opposite one.
struct Hemispheres {
  Vec3 upper{0.6, 0.7, 0.8}, lower{0.25, 0.22, 0.2};  // radiance, linear RGB, >= 0
  Vec3 axis{0, 1, 0};                                 // unit length
  HemisphereForm form = HemisphereForm::automatic;
  friend bool operator==(const Hemispheres&, const Hemispheres&) = default;
};

/// All light on a scene. Intensities are radiometric. With `pi_scaled` the irradiances are Schueler's E / pi,
/// so that a white Lambert surface under 1 at normal incidence has radiance 1.
struct LightSetup {
  std::vector<Light> lights;
  std::optional<Hemispheres> hemispheres;
  std::string environment;  // file of a latitude-longitude HDR picture, or a name of core/light/studio.h;
                            // empty: none
  double environment_scale = 1;
  // Albedo of a level, endless, diffuse ground under the object at y = -1, which lights it from below by one bounce;
  // none: no ground. It takes the place of what environment and hemispheres have below the horizon.
  std::optional<Vec3> ground;
  bool pi_scaled = false;
  friend bool operator==(const LightSetup&, const LightSetup&) = default;
};

/// The unit vector at an elevation above the horizon and at an azimuth that counts from +z (the camera)
/// towards +x (the right).
Vec3 direction_of_angles(double elevation_deg, double azimuth_deg);

/// `v` scaled to length 1; (0, 0, -1), away from the viewer, where its length is 0 or not finite.
Vec3 normalised_direction(const Vec3& v);

/// Throws Error that names `what` for negative, NaN or infinite numbers, for directions of length zero, and
/// for an inner cone wider than the outer one.
void validate(const LightSetup& setup, std::string_view what);

/// Reads a light setup (resources/schema/lights.schema.json). Throws Error that names the file and the JSON
/// pointer.
LightSetup parse_lights(std::string_view text, std::string_view file);

/// A light setup as JSON that parse_lights() reads back with equal numbers; without a line break at its end.
///   indent   how many blanks there are before the closing brace
std::string format_lights(const LightSetup& setup, int indent = 0);

/// The light of the sources: three directional lights (key, fill, rim) and two hemispheres. Pictures for which
/// the user names no light are made with studio_lights() (core/light/studio.h).
LightSetup default_lights();

/// Sets the environment; an empty name removes it. Another environment takes away what stands for the same light: the
/// hemispheres, and the flashes of "studio" with its scale, which come back with it. Other lights stay.
void choose_environment(LightSetup& setup, const std::string& environment);

/// `count` white directional lights, spread over the half space in front of the object.
std::vector<Light> spread_lights(int count);

}  // namespace etak
