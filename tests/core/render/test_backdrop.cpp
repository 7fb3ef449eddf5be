// SPDX-License-Identifier: Apache-2.0
#include "core/render/backdrop.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/material/library.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"

namespace etak {
namespace {

const Environment& studio() {
  static const Environment made(environment_picture(*find_studio("studio"), 256), 1, "studio", 2);
  return made;
}

Scene scene_of(double gloss = 1) {
  Scene out;
  out.width = out.height = 64;
  out.surface.f0 = {0.04, 0.04, 0.04};
  out.surface.gloss = gloss;
  out.specular = find_model(default_specular);
  out.specular_values = model_values(*out.specular, out.surface, {});
  out.lights.environment = "given";
  return out;
}

Image drawn_with_backdrop(const Scene& scene, Precision precision = Precision::f32) {
  Image out;
  render_cpu(scene, &studio(), 2, precision, out);
  return out;
}

double at(const Image& picture, int x, int y) {
  return double{picture.at(x, y)[1]};
}

}  // namespace

TEST_CASE(
    "without a backdrop the background has one colour; with one it is the environment behind the object") {
  Scene scene = scene_of();
  const Image plain = drawn_with_backdrop(scene);
  CHECK(at(plain, 0, 0) == Approx(0.18));
  scene.backdrop = {true, 0, false};
  const Image seen = drawn_with_backdrop(scene);
  CHECK(seen.at(0, 0)[3] == 0);
  // The corner's ray: the camera sees 30 degrees over the height.
  const double slope = std::tan(15 * 3.14159265358979323846 / 180), at_corner = 63.0 / 64 * slope;
  const double length = std::sqrt(1 + 2 * at_corner * at_corner);
  const Vec3 sight{-at_corner / length, at_corner / length, -1 / length};
  CHECK(at(seen, 0, 0) == Approx(studio().radiance(sight)[1]).epsilon(1e-4));
  // The object itself is drawn as before.
  CHECK(at(seen, 32, 32) == at(plain, 32, 32));
  // Turned to the right by 90 degrees, the camera looks from +x at what lies at -x.
  scene.view = View{90, 0, 0, 0, 1};
  const SceneBackdrop turned(scene, &studio(), Camera(scene));
  CHECK(turned.at(0, 0)[1] == Approx(studio().radiance({-1, 0, 0})[1]).epsilon(1e-6));
  scene.environment_turn_deg = 90;
  const SceneBackdrop both(scene, &studio(), Camera(scene));
  CHECK(both.at(0, 0)[1] ==
        Approx(studio().radiance(EnvironmentTurn(90).to_map({-1, 0, 0}))[1]).epsilon(1e-6));
  CHECK_FALSE(SceneBackdrop(scene, nullptr, Camera(scene)).shows_environment());
}

TEST_CASE("the blur goes from the picture to the dullest level without a step") {
  const Vec3 up{0, 1, 0};
  Vec3 before = studio().blurred(0).at(up);
  CHECK(before[1] == Approx(studio().radiance(up)[1]).epsilon(1e-6));
  for (int i = 1; i <= 900; ++i) {
    const Vec3 now = studio().blurred(i / 900.0).at(up);
    CHECK(std::abs(now[1] - before[1]) < 0.02);
    before = now;
  }
  const Image& dullest = studio().levels().back().map;
  CHECK(before[1] == Approx((Environment::Blurred{&dullest, &dullest, 0}.at(up)[1])).epsilon(1e-6));
}

TEST_CASE("the ground is dark where the ball lies on it, and does not change a quad or the 18 % card") {
  Scene scene = scene_of();
  scene.view = View{0, 20, 0, 0, 0.5};
  scene.backdrop.ground = true;
  const Image picture = drawn_with_backdrop(scene);
  // From 20 degrees above, below the ball: the shadow; far to the side and above the horizon: the background.
  CHECK(at(picture, 32, 48) < 0.5 * 0.18);
  CHECK(at(picture, 0, 63) > 0.8 * 0.18);
  CHECK(at(picture, 32, 0) == Approx(0.18).epsilon(0.05));
  scene.shape = Shape::quad;
  CHECK(at(drawn_with_backdrop(scene), 32, 63) == Approx(0.18));
}

TEST_CASE("clear bodies of the library pass light by their k, others none") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const auto surface = [&](const char* id, const Vec3& diffuse) {
    const auto material = library.find(id);
    REQUIRE(material);
    return surface_of(*material, material->preferred_dataset(), diffuse, 1.0);
  };
  for (const char* id : {"water", "fused_silica", "diamond"}) {
    CAPTURE(std::string(id));
    const SurfaceValues clear = surface(id, {0, 0, 0});
    REQUIRE(clear.passing);
    for (const double each : *clear.passing) {
      CHECK(each > 0.9);
      CHECK(each <= 1);
    }
  }
  CHECK_FALSE(surface("water", {0.1, 0, 0}).passing);  // painted
  CHECK_FALSE(surface("gold", {0, 0, 0}).passing);
  CHECK_FALSE(surface("silicon", {0, 0, 0}).passing);
}

TEST_CASE("a clear ball shows the environment upside down, without its own colour, as the reference does") {
  Scene scene = scene_of();
  scene.surface.opacity = 0;
  scene.surface.passing = Vec3{1, 0.5, 1};
  scene.background = {9, 9, 9};  // what lies behind in the old way must not be seen
  const Image clear = drawn_with_backdrop(scene);
  // The middle looks straight through: both surfaces take 4 %, half of green is absorbed.
  const double straight = studio().specular({0, 0, -1}, 1)[1];
  const double mirrored = studio().specular({0, 0, 1}, 1)[1];
  CHECK(at(clear, 32, 32) == Approx(0.5 * 0.96 * 0.96 * straight + 0.04 * mirrored).epsilon(0.03));
  CHECK(at(clear, 32, 32) < 5);
  // Green is the less the longer the way: least in the middle.
  const auto greenness = [&](int x) { return at(clear, x, 32) / double{clear.at(x, 32)[0]}; };
  CHECK(greenness(32) < greenness(6));
  ReferenceOptions options;
  options.samples_per_side = 2;
  options.light_samples = 0;
  scene.lights.lights.clear();
  const Reference reference = render_reference(scene, &studio(), options);
  scene.specular_values = std::vector<double>(scene.specular_values.size(), 0);
  scene.surface.f0 = {0, 0, 0};
  const Image through = drawn_with_backdrop(scene, Precision::f64);
  CHECK(double{reference.picture.at(20, 40)[1]} == Approx(at(through, 20, 40)).epsilon(0.05));
  // Without an environment the background is seen as it always was.
  Image old;
  render_cpu(scene, nullptr, 1, Precision::f32, old);
  CHECK(at(old, 32, 32) > 8);
}

TEST_CASE("a quickly prefiltered environment is the full one but for its details") {
  const Image picture = environment_picture(*find_studio("studio"), 256);
  const Environment quick(picture, 1, "quick", 1, Environment::Prefilter::quick);
  for (const Vec3& d : {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-0.6, 0.64, 0.48}, Vec3{0.8, -0.6, 0}}) {
    CHECK(quick.irradiance(d)[1] == Approx(studio().irradiance(d)[1]).epsilon(0.02));
    for (const double gloss : {0.0, 0.5, 0.75})
      CHECK(quick.specular(d, gloss)[1] == Approx(studio().specular(d, gloss)[1]).epsilon(0.06).margin(0.01));
    CHECK(quick.radiance(d) == studio().radiance(d));
  }
}

}  // namespace etak
