// SPDX-License-Identifier: Apache-2.0
#include "core/material/seen_stack.h"
#include "core/render/reference.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/material/f0.h"
#include "core/material/library.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene scene_of_material(const char* material, const char* model, int size) {
  const auto found = MaterialLibrary::builtin().find(material);
  REQUIRE(found);
  Scene scene;
  scene.width = scene.height = size;
  scene.surface = surface_of(*found, found->preferred_dataset(), {0, 0, 0}, 0.6);
  scene.specular = find_model(model);
  scene.specular_values = model_values(*scene.specular, scene.surface, {});
  scene.lights = default_lights();
  return scene;
}

}  // namespace

TEST_CASE("the spectral table is F0 and F82 of the F0 solver, and within 3e-5 of the sum between its steps") {
  const F0Solver solver{F0Options{}};
  for (const char* id : {"gold", "silver", "silicon", "fused_silica"}) {
    const auto material = MaterialLibrary::builtin().find(id);
    REQUIRE(material);
    const Dataset& dataset = material->preferred_dataset();
    const auto& optics = std::get<OpticalConstants>(dataset.optics);
    const SpectralFresnel table(optics);
    const F0Result f0 = solver.solve(dataset.optics);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(table.at(1)[c] == Approx(vec(f0.srgb_linear)[c]).epsilon(1e-9));
      CHECK(table.at(1.0 / 7)[c] == Approx(vec(*f0.f82)[c]).epsilon(1e-5));
    }
    for (const double cosine : {1e-4, 0.0021, 0.0123, 0.0777, 0.3331, 0.7}) {
      const Vec3 sum = SeenStack(optics)(cosine);
      for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(table.at(cosine)[c] - sum[c]) < 3e-5);
    }
  }
}

TEST_CASE("with no optics and directional lights the reference is the real-time picture inside the object") {
  Scene scene = scene_of_material("iron", "ggx-schlick", 48);
  scene.surface.optics.reset();
  scene.lights.hemispheres.reset();
  const Reference reference = render_reference(scene, nullptr, {1, 0, 2});
  Image quick;
  render_cpu(scene, nullptr, 1, Precision::f64, quick);
  CHECK(reference.standard_error == 0);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      if (quick.at(x, y)[3] == 1)
        for (std::size_t c = 0; c < 3; ++c)
          REQUIRE(reference.picture.at(x, y)[c] == Approx(quick.at(x, y)[c]).epsilon(1e-5).margin(1e-6));
}

TEST_CASE("an RGB model lies within its Fresnel error of the spectral reference") {
  // At any angle, F82 for gold is within 0.03 of the spectral reference, and Schlick within 0.1.
  Scene scene = scene_of_material("gold", "ggx-f82", 48);
  scene.lights.hemispheres.reset();
  const Reference reference = render_reference(scene, nullptr, {1, 0, 2});
  Image quick;
  render_cpu(scene, nullptr, 1, Precision::f64, quick);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      if (quick.at(x, y)[3] < 1) continue;
      const float truth = reference.picture.at(x, y)[1];
      REQUIRE(std::abs(quick.at(x, y)[1] - truth) <= 0.03f * truth + 1e-5f);
    }
}

TEST_CASE("the reference's lobe is the model with F = 1") {
  const auto lobe = lobe_of(*find_model("schueler-full"), {0.2, 0.4, 1.4, 3, 2.4, 1.8, 0.5});
  REQUIRE(lobe);
  const auto same = lobe_of(*find_model("beckmann-schlick"), {0.5, 0.5, 0.5, std::sqrt(2.0 / 66)});
  REQUIRE(same);
  const Directions d{0.5, 0.1, std::sqrt(1 - 0.26), -0.4, 0.2, std::sqrt(1 - 0.2)};
  double a[3], b[3];
  lobe->model->f64(d, lobe->values.data(), a);
  same->model->f64(d, same->values.data(), b);
  CHECK(a[0] == Approx(b[0]).epsilon(1e-9));
  CHECK(a[2] == Approx(b[0]).epsilon(1e-9));
  CHECK_FALSE(lobe_of(*find_model("lambert"), {0.5, 0.5, 0.5}));
}

TEST_CASE(
    "sampled light: same for any number of threads, and the error shrinks faster than the root of the samples") {
  Scene scene = scene_of_material("copper", "ggx-schlick", 24);
  scene.lights.lights.clear();
  const Reference one = render_reference(scene, nullptr, {2, 16, 1});
  CHECK(render_reference(scene, nullptr, {2, 16, 3}).picture == one.picture);
  const Reference more = render_reference(scene, nullptr, {2, 256, 2});
  CHECK(one.standard_error > 0);
  CHECK(one.standard_error / more.standard_error > 5);
}

TEST_CASE("Lambert in a constant surrounding is exact, beside a specular part too") {
  const Environment white(Image(64, 32, 3, 2.0f), 1, "white", 1);
  Scene scene;
  scene.width = scene.height = 16;
  scene.diffuse = find_model("lambert");
  scene.diffuse_values = {0.25, 0.5, 1};
  const Reference matte = render_reference(scene, &white, {1, 1, 1});
  CHECK(matte.standard_error < 1e-12);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(matte.picture.at(8, 8)[c] == Approx(2 * scene.diffuse_values[c]).epsilon(1e-6));
  scene.specular = find_model("blinn-phong");
  scene.specular_values = {0.25, 0.5, 1, 0, 0, 0, 20};
  scene.diffuse = nullptr;
  const Reference combined = render_reference(scene, &white, {1, 16, 1});
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(combined.picture.at(8, 8)[c] == Approx(2 * scene.specular_values[c]).epsilon(1e-6));
}

TEST_CASE("the reference is right where the light is black or a single texel of 1e30") {
  Scene scene = scene_of_material("gold", "ggx-f82", 16);
  scene.lights = {};
  Image map(64, 32, 3, 0.0f);
  const Environment black(map, 1, "black", 1);
  const Reference dark = render_reference(scene, &black, {1, 16, 1});
  CHECK(dark.picture.at(8, 8)[0] == 0);
  for (std::size_t c = 0; c < 3; ++c) map.at(4, 10)[c] = 1e30f;
  const Environment sun(map, 1, "sun", 1);
  const Reference bright = render_reference(scene, &sun, {2, 64, 1});
  for (const float value : bright.picture.values) REQUIRE((value >= 0 && std::isfinite(value)));
  CHECK(bright.picture.at(8, 8)[0] > 1e20f);
}

TEST_CASE("the stated standard error is the spread that is seen against a finer reference") {
  Scene scene = scene_of_material("copper", "ggx-schlick", 24);
  scene.lights.lights.clear();
  const Reference coarse = render_reference(scene, nullptr, {2, 16, 2});
  const Reference fine = render_reference(scene, nullptr, {2, 2048, 2});
  double squares = 0, count = 0;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      const auto a = coarse.picture.at(x, y), b = fine.picture.at(x, y);
      if (a[3] == 0) continue;
      const double off =
          0.2126 * double{a[0] - b[0]} + 0.7152 * double{a[1] - b[1]} + 0.0722 * double{a[2] - b[2]};
      squares += off * off;
      ++count;
    }
  CHECK(std::sqrt(squares / count) == Approx(coarse.standard_error).epsilon(0.2));
}

}  // namespace etak
