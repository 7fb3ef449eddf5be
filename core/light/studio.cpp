// SPDX-License-Identifier: Apache-2.0
#include "core/light/studio.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/color/luminance.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// Where the key light and the strip behind stand, in the studio and as flashes.
struct SkyPlace {
  double elevation_deg, azimuth_deg;
};
constexpr SkyPlace key_at{38, -40}, kicker_at{22, 142};
constexpr double key_share = 0.2;

double smooth_step(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

Vec3 mixed(const Vec3& a, const Vec3& b, double share) {
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = a[i] * (1 - share) + b[i] * share;
  return out;
}

// How much of the lamp is seen in a direction: 1 inside, 0 outside.
double seen_share(const Lamp& lamp, const Vec3& d) {
  const double ahead = dot(d, lamp.towards);
  if (ahead <= 0) return 0;
  const double x = std::abs(dot(d, lamp.right)) / (ahead * lamp.half_width);
  const double y = std::abs(dot(d, lamp.up)) / (ahead * lamp.half_height);
  if (x >= 1 || y >= 1) return 0;
  const auto fade = [&](double at) { return smooth_step((1 - at) / lamp.edge); };
  return lamp.round ? fade(std::sqrt(x * x + y * y)) : fade(x) * fade(y);
}

// A lamp that stands upright, `width_deg` and `height_deg` wide as seen from the object.
Lamp lamp_at(const SkyPlace& at, double width_deg, double height_deg, double edge, const Vec3& radiance) {
  const auto tangent = [](double whole_deg) { return math::tan(whole_deg / 2 * std::numbers::pi / 180); };
  Lamp out;
  out.towards = direction_of_angles(at.elevation_deg, at.azimuth_deg);
  out.right = direction_of_angles(0, at.azimuth_deg + 90);
  out.up = direction_of_angles(at.elevation_deg + 90, at.azimuth_deg);
  out.half_width = tangent(width_deg);
  out.half_height = tangent(height_deg);
  out.edge = edge;
  out.radiance = radiance;
  return out;
}

Lamp box(const SkyPlace& at, double width_deg, double height_deg, double edge, double radiance) {
  return lamp_at(at, width_deg, height_deg, edge, {radiance, radiance, radiance});
}

Lamp disc(const SkyPlace& at, double width_deg, double height_deg, double edge, const Vec3& radiance) {
  Lamp out = lamp_at(at, width_deg, height_deg, edge, radiance);
  out.round = true;
  return out;
}

Vec3 grey(double value) {
  return {value, value, value};
}

// A key box and a large fill before the object, a box overhead, two strips behind; a dark floor that rises to
// the wall.
Studio soft_boxes() {
  return {grey(0.025),
          grey(0.55),
          grey(0.04),
          1.6,
          0.45,
          {box(key_at, 74, 66, 0.95, 3.4), box({6, 66}, 44, 96, 0.9, 1.5), box({86, 0}, 90, 70, 0.8, 1.8),
           box(kicker_at, 26, 96, 0.7, 3.2), box({14, -128}, 20, 96, 0.7, 2.4)}};
}

// Strips at both sides and one above draw the outline; what faces the camera stays dark.
Studio strips() {
  return {grey(0.015),
          grey(0.09),
          grey(0.02),
          1.5,
          0.08,
          {box({12, -72}, 16, 120, 0.6, 5), box({12, 72}, 16, 120, 0.6, 5), box({68, 180}, 100, 14, 0.6, 6),
           box({30, -8}, 26, 20, 0.7, 1.6)}};
}

// The overcast sky of the CIE (ISO 15469, type 16): (1 + 2 y) / 3 of the zenith. The ground reflects 20 % of
// its irradiance on it, 7 pi / 9.
Studio overcast() {
  return {grey(0.2 * 7 / 9), grey(1.0 / 3), grey(1), 1, 0.03, {}};
}

// A sun of 6 degrees (a true one has 0.5, and 140 times the radiance) in its glow, a blue sky all around.
Studio sunset() {
  return {{0.055, 0.042, 0.036},
          {0.33, 0.27, 0.30},
          {0.07, 0.12, 0.24},
          3,
          0.02,
          {disc({6, -48}, 130, 62, 1, {1.7, 0.78, 0.3}), disc({9, -48}, 6, 6, 0.4, {110, 56, 20})}};
}

// One strip in a dark room.
Studio one_strip() {
  return {grey(0.004), grey(0.012), grey(0.004), 1, 0.1, {box({18, -34}, 12, 84, 0.6, 9)}};
}

// `studio` with all of its radiances times the factor that exposes a grey card.
Studio exposed_for_card(Studio studio) {
  const Vec3 facing = irradiance_before_camera(studio);
  const double factor = std::numbers::pi / luminance_of(facing);
  for (Vec3* each : {&studio.floor, &studio.horizon, &studio.top}) *each = scaled(*each, factor);
  for (Lamp& lamp : studio.lamps) lamp.radiance = scaled(lamp.radiance, factor);
  return studio;
}

Light flash(const SkyPlace& at, double irradiance) {
  Light out;
  out.direction = scaled(direction_of_angles(at.elevation_deg, at.azimuth_deg), -1);
  out.intensity = irradiance;
  return out;
}

}  // namespace

Vec3 radiance(const Studio& studio, const Vec3& d) {
  const double y = std::clamp(d[1], -1.0, 1.0);
  const double rise = math::pow(1 - std::max(y, 0.0), studio.fall);
  const Vec3 wall = mixed(studio.top, studio.horizon, rise);
  Vec3 out = mixed(studio.floor, wall, smooth_step(0.5 + y / (2 * studio.skirting)));
  for (const Lamp& lamp : studio.lamps) out = mixed(out, lamp.radiance, seen_share(lamp, d));
  return out;
}

Vec3 irradiance_before_camera(const Studio& studio) {
  // Nusselt's analogue: over the unit disc that the half sphere throws on the plane, an area is a solid angle
  // times its cosine.
  constexpr int side = 128;
  Vec3 sum{};
  int inside = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double x = (2 * i + 1.0) / side - 1, y = (2 * j + 1.0) / side - 1, z2 = 1 - x * x - y * y;
      if (z2 <= 0) continue;
      ++inside;
      const Vec3 from = radiance(studio, {x, y, std::sqrt(z2)});
      for (std::size_t c = 0; c < 3; ++c) sum[c] += from[c];
    }
  return scaled(sum, std::numbers::pi / inside);
}

const std::vector<NamedStudio>& named_studios() {
  static const std::vector<NamedStudio> all{
      {"studio", "soft boxes, dark floor", exposed_for_card(soft_boxes())},
      {"rim", "strips at both sides", exposed_for_card(strips())},
      {"overcast", "overcast sky of the CIE", exposed_for_card(overcast())},
      {"sunset", "low sun, blue sky", exposed_for_card(sunset())},
      {"night", "one strip in the dark", exposed_for_card(one_strip())}};
  return all;
}

const Studio* find_studio(std::string_view name) {
  for (const NamedStudio& each : named_studios())
    if (each.name == name) return &each.studio;
  return nullptr;
}

LightSetup studio_lights() {
  const double key_cosine = direction_of_angles(key_at.elevation_deg, key_at.azimuth_deg)[2];
  LightSetup out;
  out.lights = {flash(key_at, key_share * std::numbers::pi / key_cosine), flash(kicker_at, 0.8)};
  out.environment = "studio";
  out.environment_scale = 1 - key_share;
  return out;
}

}  // namespace etak
