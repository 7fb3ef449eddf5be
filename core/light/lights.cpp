// SPDX-License-Identifier: Apache-2.0
#include "core/light/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/light/studio.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double largest_area_side = 1e6;  // in radii of the object

// Checks one light setup. `what` is the file or option it comes from; places inside of it are JSON pointers.
struct Checker {
  std::string_view what;

  [[noreturn]] void fail(const std::string& pointer, double found, std::string_view expected) const {
    throw Error::at(std::string(what) + '#' + pointer, number(found, 9), expected);
  }
  void at_least_zero(const std::string& pointer, double value) const {
    if (!(value >= 0) || !std::isfinite(value)) fail(pointer, value, "a finite number of at least 0");
  }
  void finite(const std::string& pointer, double value) const {
    if (!std::isfinite(value)) fail(pointer, value, "a finite number");
  }
  void color(const std::string& pointer, const Vec3& value) const {
    for (std::size_t i = 0; i < 3; ++i) at_least_zero(pointer + '/' + std::to_string(i), value[i]);
  }
  void position(const std::string& pointer, const Vec3& value) const {
    for (std::size_t i = 0; i < 3; ++i) finite(pointer + '/' + std::to_string(i), value[i]);
  }
  void direction(const std::string& pointer, const Vec3& value) const {
    position(pointer, value);
    const double length = math::hypot(value[0], value[1], value[2]);
    if (!(length > 1e-12)) throw Error::at(std::string(what) + '#' + pointer, "a direction of length zero");
  }

  void light(const std::string& pointer, const Light& light) const {
    color(pointer + "/color", light.color);
    at_least_zero(pointer + "/intensity", light.intensity);
    if (light.kind != LightKind::directional) position(pointer + "/position", light.position);
    if (light.kind != LightKind::point) direction(pointer + "/direction", light.direction);
    if (is_area(light.kind)) {
      for (const auto& [size, value] : {std::pair("/width", light.width), std::pair("/height", light.height)})
        if (!(value > 0 && value <= largest_area_side))
          fail(pointer + size, value, "a size above 0, at most " + number(largest_area_side, 9));
      return direction(pointer + "/up", light.up);
    }
    if (light.kind != LightKind::spot) return;
    if (!(light.inner_deg >= 0 && light.inner_deg <= 90))
      fail(pointer + "/inner_deg", light.inner_deg, "a half-angle of 0 to 90 degrees");
    if (!(light.outer_deg >= 0 && light.outer_deg <= 90))
      fail(pointer + "/outer_deg", light.outer_deg, "a half-angle of 0 to 90 degrees");
    if (light.inner_deg > light.outer_deg)
      fail(pointer + "/inner_deg", light.inner_deg, "at most outer_deg, " + number(light.outer_deg, 9));
  }
};

Light directional_from(double elevation_deg, double azimuth_deg, const Vec3& color, double irradiance) {
  Light light;
  const Vec3 to = direction_of_angles(elevation_deg, azimuth_deg);
  light.direction = {-to[0], -to[1], -to[2]};
  light.color = color;
  light.intensity = irradiance;
  return light;
}

}  // namespace

std::string_view name(LightKind kind) {
  constexpr std::string_view names[] = {"point", "directional", "spot", "rectangle", "disc"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<LightKind> light_kind_named(std::string_view text) {
  for (const LightKind kind : light_kinds)
    if (text == name(kind)) return kind;
  return std::nullopt;
}

std::string_view name(HemisphereForm form) {
  constexpr std::array names{"auto", "model", "corrected", "wide", "printed"};
  return names[static_cast<std::size_t>(form)];
}

std::optional<HemisphereForm> hemisphere_form_named(std::string_view text) {
  for (const HemisphereForm form : hemisphere_forms)
    if (text == name(form)) return form;
  return std::nullopt;
}

void validate(const LightSetup& setup, std::string_view what) {
  const Checker check{what};
  for (std::size_t i = 0; i < setup.lights.size(); ++i)
    check.light("/lights/" + std::to_string(i), setup.lights[i]);
  if (setup.hemispheres) {
    check.color("/hemispheres/upper", setup.hemispheres->upper);
    check.color("/hemispheres/lower", setup.hemispheres->lower);
    check.direction("/hemispheres/axis", setup.hemispheres->axis);
  }
  check.at_least_zero("/environment/scale", setup.environment_scale);
  for (std::size_t i = 0; setup.ground && i < 3; ++i)
    if (const double share = (*setup.ground)[i]; !(share >= 0 && share <= 1))
      check.fail("/ground/albedo/" + std::to_string(i), share, "a share of 0 to 1");
}

LightSetup default_lights() {
  LightSetup setup;
  setup.lights = {directional_from(40, 40, {1, 0.96, 0.9}, 3.0),
                  directional_from(10, -60, {0.85, 0.92, 1}, 0.8), directional_from(30, 165, {1, 1, 1}, 2.0)};
  setup.hemispheres = Hemispheres{};
  return setup;
}

void choose_environment(LightSetup& setup, const std::string& environment) {
  const std::string before = std::exchange(setup.environment, environment);
  if (environment.empty() || environment == before) return;
  setup.hemispheres.reset();
  // The flashes of the studio are its own: another environment has lights of its own in its picture.
  const LightSetup studio = studio_lights();
  const auto gone = std::erase_if(setup.lights, [&](const Light& light) {
    return std::ranges::find(studio.lights, light) != studio.lights.end();
  });
  const bool to_studio = environment == studio.environment;
  if (to_studio) setup.lights.insert(setup.lights.begin(), studio.lights.begin(), studio.lights.end());
  if (to_studio && setup.environment_scale == 1)
    setup.environment_scale = studio.environment_scale;
  else if (!to_studio && gone != 0 && setup.environment_scale == studio.environment_scale)
    setup.environment_scale = 1;
}

Vec3 direction_of_angles(double elevation_deg, double azimuth_deg) {
  const double degree = std::numbers::pi / 180;
  const double up = elevation_deg * degree, right = azimuth_deg * degree;
  return {math::cos(up) * math::sin(right), math::sin(up), math::cos(up) * math::cos(right)};
}

Vec3 normalised_direction(const Vec3& v) {
  const double length = math::hypot(v[0], v[1], v[2]);
  if (!(length > 1e-12) || !std::isfinite(length)) return {0, 0, -1};
  return {v[0] / length, v[1] / length, v[2] / length};
}

std::vector<Light> spread_lights(int count) {
  std::vector<Light> out;
  for (int i = 0; i < count; ++i) {
    const double z = 0.25 + 0.7 * (i + 0.5) / count, s = std::sqrt(1 - z * z);
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    Light light;
    light.direction = {-s * math::cos(turn), -s * math::sin(turn), -z};
    out.push_back(light);
  }
  return out;
}

}  // namespace etak
