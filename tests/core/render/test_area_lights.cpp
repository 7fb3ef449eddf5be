// SPDX-License-Identifier: Apache-2.0
// Area lights of core/light/area.glsl against the sampled reference.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/light/area_lobes.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene ball(const char* model, double alpha, const Vec3& f0) {
  Scene scene;
  scene.width = scene.height = 40;
  scene.surface.f0 = f0;
  complete_from_f0(scene.surface);
  scene.surface.gloss = Gloss(gloss_of_exponent(std::max(1.0, exponent_of_alpha(alpha))));
  if (model == nullptr) return scene;
  scene.specular = find_model(model);
  REQUIRE(scene.specular);
  scene.specular_values = model_values(*scene.specular, scene.surface, {});
  return scene;
}

// A light that covers `degrees` as seen from the ball.
Light area(LightKind kind, const Vec3& from, double degrees) {
  const Vec3 to = normalised_direction(from);
  Light out;
  out.kind = kind;
  out.position = scaled(to, 4);
  out.direction = scaled(to, -1);
  out.width = out.height = 2 * 4 * std::tan(degrees / 2 * std::numbers::pi / 180);
  return out;
}

// Root mean square of the difference over that of the reference, over the pixels that the ball covers.
double misfit(const Scene& scene, int samples) {
  const Reference reference = render_reference(scene, nullptr, {1, samples, 2});
  Image quick;
  render_cpu(scene, nullptr, 2, Precision::f64, quick);
  double off = 0, all = 0;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x)
      for (std::size_t c = 0; c < 3 && quick.at(x, y)[3] == 1; ++c) {
        const double truth = double{reference.picture.at(x, y)[c]}, shown = double{quick.at(x, y)[c]};
        off += (shown - truth) * (shown - truth);
        all += truth * truth;
      }
  return std::sqrt(off / all);
}

constexpr Vec3 front{0, 0, 1}, key{-0.4, 0.5, 1}, to_side{1, 0.4, 0.3}, behind{0, 1, -0.4};

}  // namespace

TEST_CASE(
    "an area light on GGX is within 2 % of the reference, and narrow lobes of glass from behind within 4 %") {
  for (const LightKind kind : {LightKind::rectangle, LightKind::disc})
    for (const double f0 : {0.04, 0.95})
      for (const double alpha : {0.1, 0.25, 0.8})
        for (const auto& [from, degrees] :
             {std::pair(key, 5.0), std::pair(key, 90.0), std::pair(to_side, 20.0), std::pair(front, 60.0),
              std::pair(behind, 45.0), std::pair(behind, 90.0)}) {
          Scene scene = ball("ggx-schlick", alpha, {f0, f0, f0});
          scene.lights.lights = {area(kind, from, degrees)};
          INFO(name(kind) << " F0 " << f0 << " alpha " << alpha << " from " << from[0] << ' ' << from[1]
                          << ' ' << from[2] << ", " << degrees << " degrees");
          const bool hard = from == behind && f0 < 0.1 && alpha < 0.2;
          CHECK(misfit(scene, from == behind ? 1000 : 400) < (hard ? 0.04 : 0.02));
        }
}

TEST_CASE("a small area light is right for every model and Fresnel term, also without a fit of its lobe") {
  for (const char* model :
       {"schueler-optimized-bounded", "schueler-full", "ggx-exact", "ggx-f82", "beckmann-smith",
        "ggx-schlick-compensated", "phong-implicit", "abc-schlick", "blinn-phong", "cook-torrance"}) {
    Scene scene = ball(model, 0.3, {0.95, 0.64, 0.54});
    scene.lights.lights = {area(LightKind::disc, key, 5)};
    INFO(model);
    CHECK(misfit(scene, 300) < 0.02);
  }
}

TEST_CASE("Lambert under an area light is exact") {
  for (const Vec3& from : {front, to_side, behind})
    for (const double degrees : {5.0, 90.0}) {
      Scene scene = ball(nullptr, 0.5, {0.04, 0.04, 0.04});
      scene.surface.diffuse = {0.8, 0.5, 0.2};
      scene.diffuse = find_model("lambert");
      scene.diffuse_values = {0.8, 0.5, 0.2};
      scene.lights.lights = {area(LightKind::rectangle, from, degrees)};
      INFO(from[0] << ' ' << from[1] << ' ' << from[2] << ", " << degrees);
      CHECK(misfit(scene, 2000) < 0.004);
    }
}

TEST_CASE("far away an area light is a point light of its radiance times its area") {
  Scene scene = ball("ggx-schlick", 0.4, {0.9, 0.9, 0.9});
  Light light = area(LightKind::rectangle, key, 1);
  light.position = scaled(light.position, 100);
  light.intensity = 3;
  scene.lights.lights = {light};
  Image wide, narrow;
  render_cpu(scene, nullptr, 1, Precision::f64, wide);
  light.kind = LightKind::point;
  light.intensity = 3 * light.width * light.height;
  scene.lights.lights = {light};
  render_cpu(scene, nullptr, 1, Precision::f64, narrow);
  for (std::size_t i = 0; i < wide.values.size(); ++i)
    REQUIRE(double{wide.values[i]} == Approx(double{narrow.values[i]}).epsilon(2e-3).margin(1e-7));
}

TEST_CASE("an area lights nothing behind it, and single precision agrees with double") {
  Scene scene = ball("ggx-schlick", 0.2, {0.9, 0.9, 0.9});
  scene.diffuse = find_model("lambert");
  scene.surface.diffuse = {0.5, 0.5, 0.5};
  scene.diffuse_values = {0.5, 0.5, 0.5};
  Light light = area(LightKind::disc, key, 40);
  scene.lights.lights = {light};
  Image f32, f64;
  render_cpu(scene, nullptr, 1, Precision::f32, f32);
  render_cpu(scene, nullptr, 1, Precision::f64, f64);
  for (std::size_t i = 0; i < f64.values.size(); ++i)
    REQUIRE(double{f32.values[i]} == Approx(double{f64.values[i]}).epsilon(2e-3).margin(1e-4));
  light.direction = scaled(light.direction, -1);
  scene.lights.lights = {light};
  scene.background = {0, 0, 0};
  render_cpu(scene, nullptr, 1, Precision::f64, f64);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) REQUIRE(f64.at(x, y)[c] == 0);
}

TEST_CASE("the axes of an area are those of its lit side, also where it looks along its height") {
  for (const Vec3& direction : {Vec3{0, 0, -1}, Vec3{0, -1, 0}, Vec3{0, 1, 0}, Vec3{0.6, -0.64, 0.48}}) {
    Light light;
    light.kind = LightKind::rectangle;
    light.direction = direction;
    light.width = 2;
    light.height = 3;
    const auto [right, up] = area_axes(light);
    CHECK(std::sqrt(dot(right, right)) == Approx(1));
    CHECK(std::sqrt(dot(up, up)) == Approx(1.5));
    CHECK(std::abs(dot(right, up)) + std::abs(dot(right, direction)) + std::abs(dot(up, direction)) < 1e-12);
    // Turning from the width to the height is counter-clockwise for whoever the light shines on.
    CHECK((right[1] * up[2] - right[2] * up[1]) * direction[0] +
              (right[2] * up[0] - right[0] * up[2]) * direction[1] +
              (right[0] * up[1] - right[1] * up[0]) * direction[2] ==
          Approx(-1.5));
    CHECK(area_density(light, scaled(direction, 5), scaled(direction, -1)) > 0);
    CHECK(area_density(light, scaled(direction, -5), direction) == 0);
  }
}

}  // namespace etak
