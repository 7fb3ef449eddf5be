// SPDX-License-Identifier: Apache-2.0
#include "core/render/cpu_renderer.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/material/library.h"
#include "core/render/display.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene scene_with(const char* specular, const char* diffuse, int size = 96) {
  Scene scene;
  scene.width = scene.height = size;
  scene.surface.f0 = {0.9, 0.6, 0.3};
  scene.surface.f82 = {0.93, 0.75, 0.6};
  solve_index(scene.surface);
  scene.surface.diffuse = {0.3, 0.2, 0.1};
  scene.surface.gloss = 0.6;
  scene.specular = specular ? find_model(specular) : nullptr;
  scene.diffuse = diffuse ? find_model(diffuse) : nullptr;
  if (scene.specular) scene.specular_values = model_values(*scene.specular, scene.surface, {});
  if (scene.diffuse) scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  scene.lights = default_lights();
  return scene;
}

Light directional(const Vec3& to_light, double intensity = 1) {
  const double length =
      std::sqrt(to_light[0] * to_light[0] + to_light[1] * to_light[1] + to_light[2] * to_light[2]);
  Light light;
  light.direction = {-to_light[0] / length, -to_light[1] / length, -to_light[2] / length};
  light.intensity = intensity;
  return light;
}

Image drawn_by_cpu(const Scene& scene, Precision precision = Precision::f64, unsigned threads = 1,
                   const Environment* environment = nullptr) {
  Image out;
  render_cpu(scene, environment, threads, precision, out);
  return out;
}

}  // namespace

TEST_CASE("the picture is the same for any number of threads") {
  Scene scene = scene_with("ggx-schlick", "lambert");
  scene.lights.lights.push_back(directional({0.2, -0.5, 1}));
  for (const Precision precision : {Precision::f32, Precision::f64}) {
    const Image one = drawn_by_cpu(scene, precision, 1);
    for (const unsigned threads : {2u, 3u, 16u}) CHECK(drawn_by_cpu(scene, precision, threads) == one);
  }
}

TEST_CASE("codes drawn at once are those of the drawn picture") {
  for (const Shape shape : {Shape::sphere, Shape::quad})
    for (const Transfer transfer : {Transfer::srgb, Transfer::square_root}) {
      Scene scene = scene_with("ggx-schlick", "lambert");
      scene.shape = shape;
      scene.transfer = transfer;
      scene.exposure = 1.7;
      scene.width = 301;  // more than a chunk, and no whole number of blocks
      const Image8 expected = to_codes(drawn_by_cpu(scene, Precision::f32), scene.exposure, scene.transfer);
      for (const unsigned threads : {1u, 3u}) {
        Image8 codes;
        render_cpu_codes(scene, nullptr, threads, codes);
        CHECK(codes == expected);
      }
    }
}

TEST_CASE("orthographic and nearly orthographic views of directional lights agree for every model") {
  // The first scene uses the loops for light and viewer at infinity, the second those for any directions.
  for (const Model& model : models()) {
    const bool is_diffuse = model.kind == ModelKind::diffuse;
    const std::string id(model.id);
    Scene scene = scene_with(is_diffuse ? nullptr : id.c_str(), is_diffuse ? id.c_str() : nullptr, 64);
    scene.shape = Shape::quad;
    const Image far = drawn_by_cpu(scene, Precision::f32);
    scene.perspective = true;
    scene.field_of_view_deg = 1;
    const Image near = drawn_by_cpu(scene, Precision::f32);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(far.at(32, 32)[c] == Approx(near.at(32, 32)[c]).epsilon(0.01).margin(1e-6));
  }
}

TEST_CASE("a white Lambert surface lit head-on with pi-scaled E = 1 shows 1") {
  Scene scene = scene_with(nullptr, "lambert", 33);
  scene.diffuse_values = {1, 1, 1};
  scene.surface.diffuse = {1, 1, 1};
  scene.lights = {};
  scene.lights.lights = {directional({0, 0, 1})};
  scene.lights.pi_scaled = true;
  for (const Shape shape : {Shape::sphere, Shape::quad}) {
    scene.shape = shape;
    CHECK(drawn_by_cpu(scene).at(16, 16)[0] == Approx(1).epsilon(1e-6));
    CHECK(drawn_by_cpu(scene, Precision::f32).at(16, 16)[0] == Approx(1).epsilon(1e-6));
  }
  scene.lights.pi_scaled = false;
  CHECK(drawn_by_cpu(scene).at(16, 16)[0] == Approx(1 / std::numbers::pi).epsilon(1e-6));
}

TEST_CASE("a white body in white hemispheres or a white environment shows 1 everywhere") {
  Scene scene = scene_with(nullptr, "lambert", 48);
  scene.diffuse_values = {1, 1, 1};
  scene.surface.diffuse = {1, 1, 1};
  scene.background = {1, 1, 1};
  scene.lights = {};
  scene.lights.hemispheres = Hemispheres{{1, 1, 1}, {1, 1, 1}, {0, 1, 0}, HemisphereForm::corrected};
  for (const float value : drawn_by_cpu(scene).values)
    CHECK((value == Approx(1).epsilon(1e-6) || (value >= 0 && value < 1)));
  scene.lights = {};
  const Environment white(Image(64, 32, 3, 1.0f), 1, "white", 1);
  const Image picture = drawn_by_cpu(scene, Precision::f64, 1, &white);
  for (std::size_t i = 0; i < picture.values.size(); i += 4)
    REQUIRE(picture.values[i] == Approx(1).epsilon(2e-3));
}

TEST_CASE("float and double agree to 1e-4 for every model") {
  for (const Model& model : models()) {
    const bool is_diffuse = model.kind == ModelKind::diffuse;
    const std::string id(model.id);
    Scene scene = scene_with(is_diffuse ? nullptr : id.c_str(), is_diffuse ? id.c_str() : nullptr, 64);
    const Image exact = drawn_by_cpu(scene), quick = drawn_by_cpu(scene, Precision::f32);
    float peak = 0, worst = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
      peak = std::max(peak, exact.values[i]);
      worst = std::max(worst, std::abs(exact.values[i] - quick.values[i]) / std::max(1.0f, exact.values[i]));
    }
    CAPTURE(model.id, peak, worst);
    CHECK(worst < 1e-4f);
    CHECK(peak > 0);
  }
}

TEST_CASE("mirrored lights make the mirrored picture") {
  Scene scene = scene_with("cook-torrance", "oren-nayar", 65);
  scene.lights = {};
  scene.lights.lights = {directional({0.5, 0.3, 0.8})};
  const Image right = drawn_by_cpu(scene);
  scene.lights.lights = {directional({-0.5, 0.3, 0.8})};
  const Image left = drawn_by_cpu(scene);
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 65; ++x)
      REQUIRE(right.at(x, y)[1] == Approx(left.at(64 - x, y)[1]).epsilon(1e-5).margin(1e-7));
}

TEST_CASE("the sphere covers pi over 4.84 of a square picture, the quad 1 over 1.21, edges included") {
  for (const bool perspective : {false, true}) {
    Scene scene = scene_with("ggx-schlick", nullptr, 200);
    scene.perspective = perspective;
    const auto covered = [&] {
      double sum = 0;
      const Image picture = drawn_by_cpu(scene, Precision::f32);
      for (std::size_t i = 3; i < picture.values.size(); i += 4) sum += double{picture.values[i]};
      return sum / (200.0 * 200);
    };
    CHECK(covered() == Approx(std::numbers::pi / 4.84).epsilon(2e-4));
    scene.shape = Shape::quad;
    const double tangent = std::tan(15 * std::numbers::pi / 180) / 1.1,
                 distance = std::sqrt(1 + 1 / (tangent * tangent));
    const double side = perspective ? 1 / (tangent * distance) : 1;
    CHECK(covered() == Approx(side * side / 1.21).epsilon(2e-4));
  }
}

TEST_CASE("a wide picture shows the same sphere, a narrow one cuts it") {
  Scene scene = scene_with("ggx-schlick", "lambert", 64);
  const Image square = drawn_by_cpu(scene);
  scene.width = 128;
  const Image wide = drawn_by_cpu(scene);
  scene.width = 20;
  const Image narrow = drawn_by_cpu(scene);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      REQUIRE(wide.at(x + 32, y)[0] == Approx(square.at(x, y)[0]));
      if (x >= 22 && x < 42) REQUIRE(narrow.at(x - 22, y)[0] == Approx(square.at(x, y)[0]));
    }
}

TEST_CASE("metals are lit by the hemispheres alone, and brighten at the rim") {
  const auto gold = MaterialLibrary::builtin().find("gold");
  REQUIRE(gold);
  Scene scene = scene_with("schueler-optimized-bounded", "lambert", 101);
  scene.surface = surface_of(*gold, gold->preferred_dataset(), {0.5, 0.5, 0.5}, 0.75);
  scene.specular_values = model_values(*scene.specular, scene.surface, {});
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  scene.lights = {};
  scene.lights.hemispheres = Hemispheres{{1, 1, 1}, {1, 1, 1}, {0, 1, 0}, HemisphereForm::corrected};
  const Image picture = drawn_by_cpu(scene);
  CHECK(picture.at(50, 50)[2] == Approx(scene.surface.f0[2]).epsilon(1e-3));
  CHECK(picture.at(5, 50)[2] > 1.5 * picture.at(50, 50)[2]);
  CHECK(picture.at(50, 50)[0] > picture.at(50, 50)[2]);
}

TEST_CASE("the highlight of a sharper lobe is higher in the ratio of the normalisations") {
  const auto peak = [](double gloss) {
    Scene scene = scene_with("phong-kelemen", nullptr, 255);
    scene.surface.gloss = gloss;
    scene.specular_values = model_values(*scene.specular, scene.surface, {});
    scene.lights = {};
    scene.lights.lights = {directional({0, 0, 1})};
    return double{drawn_by_cpu(scene).at(127, 127)[0]};
  };
  CHECK(peak(0.75) / peak(0.5) == Approx((512.0 + 2) / (64 + 2)).epsilon(2e-3));
}

TEST_CASE("a clear body shows the background times what Fresnel leaves, its specular light untouched") {
  Scene scene = scene_with("ggx-schlick", nullptr, 63);
  scene.surface.f0 = {0.04, 0.04, 0.04};
  scene.specular_values = model_values(*scene.specular, scene.surface, {});
  scene.lights = {};
  scene.lights.lights = {directional({0.3, 0.3, 1})};
  const Image opaque = drawn_by_cpu(scene);
  scene.surface.opacity = 0;
  scene.background = {0.5, 0.5, 0.5};
  const Image clear = drawn_by_cpu(scene);
  CHECK(clear.at(31, 31)[0] - opaque.at(31, 31)[0] == Approx(0.5 * (1 - 0.04)).epsilon(1e-4));
  CHECK(clear.at(31, 31)[3] == 1);
}

TEST_CASE("a point light falls off with the square of the distance, a spot is dark outside its cone") {
  Scene scene = scene_with(nullptr, "lambert", 65);
  scene.lights = {};
  Light light;
  light.kind = LightKind::point;
  light.position = {0, 0, 3};
  scene.lights.lights = {light};
  const double near = double{drawn_by_cpu(scene).at(32, 32)[0]};
  scene.lights.lights[0].position = {0, 0, 5};
  CHECK(near / double{drawn_by_cpu(scene).at(32, 32)[0]} == Approx(4).epsilon(1e-5));
  scene.lights.lights[0].kind = LightKind::spot;
  scene.lights.lights[0].direction = {0, 0, -1};
  scene.lights.lights[0].inner_deg = 2;
  scene.lights.lights[0].outer_deg = 4;
  const Image spot = drawn_by_cpu(scene);
  CHECK(spot.at(32, 32)[0] == Approx(near / 4).epsilon(1e-5));
  CHECK(spot.at(48, 32)[0] == 0);
}

TEST_CASE("every row is reported once") {
  Scene scene = scene_with("ggx-schlick", nullptr, 50);
  Image out;
  std::atomic<std::size_t> rows{0};
  render_cpu(scene, nullptr, 3, Precision::f32, out, [&](std::size_t count, unsigned) { rows += count; });
  CHECK(rows == 50);
}

}  // namespace etak
