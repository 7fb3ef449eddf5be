// SPDX-License-Identifier: Apache-2.0
// One bounce from the ground, emission and occlusion of a surface.
#include "core/render/ground_bounce.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "core/base/error.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene white_ball() {
  Scene scene;
  scene.width = scene.height = 33;
  scene.surface.diffuse = {1, 1, 1};
  scene.diffuse = find_model("lambert");
  scene.diffuse_values = {1, 1, 1};
  return scene;
}

Light from_above(double irradiance) {
  Light light;
  light.direction = {0, -1, 0};
  light.intensity = irradiance;
  return light;
}

Image drawn_on_ground(const Scene& scene, const Environment* environment = nullptr) {
  Image out;
  render_cpu(scene, environment, 1, Precision::f64, out);
  return out;
}

// The height of the normal in the middle of a row of the white ball.
double normal_y(const Scene& scene, int row) {
  return (scene.height / 2.0 - row - 0.5) * 2.2 / scene.height;
}

}  // namespace

TEST_CASE(
    "the ground lights a Lambert ball by its form factor (1 - ny) / 2, lit by discrete lights and hemispheres") {
  Scene scene = white_ball();
  scene.lights.lights = {from_above(2 * std::numbers::pi)};
  scene.lights.ground = Vec3{0.5, 0.25, 0};
  const Vec3 seen = ground_radiance(scene.lights, nullptr);
  CHECK(seen[0] == Approx(1));
  CHECK(seen[1] == Approx(0.5));
  CHECK(seen[2] == 0);
  scene.lights = with_ground(scene.lights);
  const Image picture = drawn_on_ground(scene);
  for (int row = 3; row < 30; ++row) {
    const double y = normal_y(scene, row);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(double{picture.at(16, row)[c]} ==
            Approx(2 * std::max(0.0, y) + seen[c] * (1 - y) / 2).margin(1e-6));
  }
  scene.lights.lights.clear();
  scene.lights.ground = Vec3{0.5, 0.5, 0.5};
  scene.lights.hemispheres = Hemispheres{{2, 2, 2}, {9, 9, 9}, {0, 1, 0}, HemisphereForm::corrected};
  CHECK(with_ground(scene.lights).hemispheres->lower[1] == Approx(1));
  scene.lights.hemispheres->axis = {0, 0, 1};
  CHECK_THROWS_AS(with_ground(scene.lights), Error);
}

TEST_CASE("in a constant environment the ground is its lower half, and the reference agrees") {
  Image sky(64, 32, 3);
  for (float& value : sky.values) value = 2;
  Scene scene = white_ball();
  scene.lights.environment = "sky";
  scene.lights.ground = Vec3{0.5, 0.5, 0.5};
  const auto around = with_ground(scene.lights, std::make_shared<const Environment>(sky, 1, "sky", 1), 1);
  const Image picture = drawn_on_ground(scene, around.get());
  const Reference reference = render_reference(scene, around.get(), {1, 900, 2});
  double mean = 0, sampled = 0;
  for (int row = 4; row < 29; ++row) {
    const double y = normal_y(scene, row);
    CHECK(double{picture.at(16, row)[1]} == Approx((1 + y) + (1 - y) / 2).epsilon(0.01));
    mean += double{picture.at(16, row)[1]};
    sampled += double{reference.picture.at(16, row)[1]};
  }
  CHECK(sampled == Approx(mean).epsilon(0.02));
  scene.lights.ground.reset();
  const auto plain = std::make_shared<const Environment>(sky, 1, "sky", 1);
  CHECK(with_ground(scene.lights, plain, 1) == plain);
}

TEST_CASE("a mirror shows the ground below its horizon") {
  Image sky(64, 32, 3);
  Scene scene = white_ball();
  scene.lights.lights = {from_above(std::numbers::pi)};
  scene.lights.ground = Vec3{0.4, 0.4, 0.4};
  const auto around = with_ground(scene.lights, std::make_shared<const Environment>(sky, 1, "black", 1), 1);
  CHECK(around->specular({0, -1, 0}, 1)[0] == Approx(0.4).epsilon(1e-3));
  CHECK(around->specular({0, 1, 0}, 1)[0] == Approx(0).margin(1e-3));
}

TEST_CASE("an area light lights the ground as its form factor says") {
  LightSetup setup;
  setup.ground = Vec3{1, 1, 1};
  Light light;
  light.kind = LightKind::disc;
  light.position = {0, 1, 0};
  light.direction = {0, -1, 0};
  light.width = light.height = 4;
  setup.lights = {light};
  // A disc of radius 2 at height 2 above a point: form factor sin^2 of 45 degrees.
  CHECK(ground_radiance(setup, nullptr)[0] == Approx(0.5).epsilon(2e-3));
}

TEST_CASE("emission is added to what is reflected, in every precision and in the reference") {
  Scene scene = white_ball();
  scene.lights.lights = {from_above(1)};
  const Image dark = drawn_on_ground(scene);
  scene.surface.emission = {0.5, 2, 0};
  scene.surface.opacity = 1;
  const Image lit = drawn_on_ground(scene);
  const Reference reference = render_reference(scene, nullptr, {1, 0, 1});
  for (int row = 3; row < 30; ++row)
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = double{dark.at(16, row)[c]} + scene.surface.emission[c];
      CHECK(double{lit.at(16, row)[c]} == Approx(expected).margin(1e-6));
      CHECK(double{reference.picture.at(16, row)[c]} == Approx(expected).margin(1e-5));
    }
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    scene.surface.emission[1] = bad;
    CHECK_THROWS_AS(validate(scene), Error);
  }
}

TEST_CASE("occlusion is a factor of hemispheres and environment, and of nothing else") {
  Scene scene = white_ball();
  scene.lights.lights = {from_above(1)};
  const Image direct = drawn_on_ground(scene);
  scene.lights.hemispheres = Hemispheres{};
  const Image open = drawn_on_ground(scene);
  scene.surface.occlusion = 0.25;
  const Image closed = drawn_on_ground(scene);
  for (int row = 3; row < 30; ++row)
    for (std::size_t c = 0; c < 3; ++c) {
      const double alone = double{direct.at(16, row)[c]};
      CHECK(double{closed.at(16, row)[c]} ==
            Approx(alone + 0.25 * (double{open.at(16, row)[c]} - alone)).margin(1e-6));
    }
  scene.surface.occlusion = 1.5;
  CHECK_THROWS_AS(validate(scene), Error);
}

}  // namespace etak
