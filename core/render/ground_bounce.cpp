// SPDX-License-Identifier: Apache-2.0
#include "core/render/ground_bounce.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/light/area_lobes.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr Vec3 under_object{0, -1, 0};
constexpr double horizontal = 1e-9;

// The irradiance of an area light on the ground under the object: the mean over even places of radiance times both cosines.
double area_irradiance(const Light& light) {
  constexpr int side = 64;
  double sum = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const Vec3 place = area_place(light, (i + 0.5) / side, (j + 0.5) / side);
      const Vec3 way{place[0] - under_object[0], place[1] - under_object[1], place[2] - under_object[2]};
      const double r = std::sqrt(dot(way, way));
      if (!(r > 0) || way[1] <= 0) continue;
      const Vec3 l = scaled(way, 1 / r);
      if (const double density = area_density(light, under_object, l); density > 0) sum += l[1] / density;
    }
  return light.intensity * sum / (side * side);
}

double irradiance_of(const Light& light, bool pi_scaled) {
  if (is_area(light.kind)) return area_irradiance(light);
  const double strength = light.intensity * (pi_scaled ? std::numbers::pi : 1);
  if (light.kind == LightKind::directional) return strength * std::max(0.0, -light.direction[1]);
  const Vec3 way{light.position[0], light.position[1] + 1, light.position[2]};
  const double r = std::max(std::sqrt(dot(way, way)), point_light_min_r);
  double share = 1;
  if (light.kind == LightKind::spot) {
    const double radian = std::numbers::pi / 180, inner = math::cos(light.inner_deg * radian),
                 outer = math::cos(light.outer_deg * radian), c = -dot(way, light.direction) / r;
    const double t =
        inner > outer ? std::clamp((c - outer) / (inner - outer), 0.0, 1.0) : (c >= inner ? 1 : 0);
    share = t * t * (3 - 2 * t);
  }
  return strength * share * std::max(0.0, way[1] / r) / (r * r);
}

}  // namespace

Vec3 ground_radiance(const LightSetup& setup, const Environment* around) {
  Vec3 irradiance{};
  if (around != nullptr) irradiance = around->irradiance({0, 1, 0});
  if (setup.hemispheres)
    for (std::size_t c = 0; c < 3; ++c) irradiance[c] += std::numbers::pi * setup.hemispheres->upper[c];
  for (const Light& light : setup.lights) {
    const double e = irradiance_of(light, setup.pi_scaled);
    for (std::size_t c = 0; c < 3; ++c) irradiance[c] += e * light.color[c];
  }
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = setup.ground.value_or(Vec3{})[c] * irradiance[c] / std::numbers::pi;
  return out;
}

std::shared_ptr<const Environment> with_ground(const LightSetup& setup,
                                               std::shared_ptr<const Environment> around, unsigned threads,
                                               Environment::Prefilter prefilter) {
  if (!setup.ground || around == nullptr) return around;
  const Vec3 seen = ground_radiance(setup, around.get());
  Image map = around->map();
  for (int y = 0; y < map.height; ++y) {
    // The row that the horizon crosses is shared by both.
    const double below = std::clamp(y + 1 - map.height / 2.0, 0.0, 1.0);
    for (int x = 0; x < map.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        float& value = map.at(x, y)[c];
        value = static_cast<float>(double{value} * (1 - below) + seen[c] * below);
      }
  }
  return std::make_shared<const Environment>(map, 1, "ground", threads, prefilter);
}

LightSetup with_ground(LightSetup setup) {
  if (!setup.ground || !setup.environment.empty()) return setup;
  if (setup.hemispheres && std::abs(setup.hemispheres->axis[1] - 1) > horizontal)
    throw Error::at("ground", "hemispheres whose axis is not up", "the axis [0, 1, 0], or no hemispheres");
  const Vec3 seen = ground_radiance(setup, nullptr);
  if (!setup.hemispheres) {
    setup.hemispheres = Hemispheres{};
    setup.hemispheres->upper = {0, 0, 0};
  }
  setup.hemispheres->lower = seen;
  return setup;
}

}  // namespace etak
