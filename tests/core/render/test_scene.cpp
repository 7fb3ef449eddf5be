// SPDX-License-Identifier: Apache-2.0
#include "core/render/scene.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/fresnel/fresnel.h"
#include "core/material/library.h"
#include "tests/support.h"

namespace etak {
namespace {

SurfaceValues library_surface(const char* id, const Vec3& diffuse = {0.5, 0.5, 0.5}) {
  const auto material = MaterialLibrary::builtin().find(id);
  REQUIRE(material);
  return surface_of(*material, material->preferred_dataset(), diffuse, 0.75);
}

Scene lambert_scene() {
  Scene scene;
  scene.diffuse = find_model("lambert");
  scene.surface.diffuse = {0.5, 0.5, 0.5};
  scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  return scene;
}

}  // namespace

TEST_CASE("metals and semiconductors have a black body, dielectrics the one that is asked for") {
  CHECK(library_surface("gold").diffuse == Vec3{0, 0, 0});
  CHECK(library_surface("silicon").diffuse == Vec3{0, 0, 0});
  CHECK(library_surface("water").diffuse == Vec3{0.5, 0.5, 0.5});
}

TEST_CASE("the n and k of a channel give its F0 and F82 back, or the residual says how far they are off") {
  for (const char* id : {"silver", "copper", "iron", "aluminium", "fused_silica", "water", "silicon"}) {
    const SurfaceValues s = library_surface(id);
    for (std::size_t c = 0; c < 3; ++c) {
      CAPTURE(id, c);
      const double off0 = std::abs(f64::f0(s.n[c], s.k[c]) - s.f0[c]);
      const double off82 = std::abs(f64::fresnel_exact(s.n[c], s.k[c], f82_cosine) - s.f82[c]);
      CHECK(std::max(off0, off82) == Approx(s.nk_residual[c]).margin(1e-15));
      CHECK(s.nk_residual[c] < 2e-4);
      CHECK((s.n[c] > 0 && s.k[c] >= 0));
    }
  }
}

TEST_CASE("gold's red lies outside every n and k: the residual tells, and green and blue are exact") {
  const SurfaceValues gold = library_surface("gold");
  CHECK(gold.f0[0] > 1);
  CHECK(gold.nk_residual[0] > 0.01);
  CHECK(gold.nk_residual[0] < 0.06);
  CHECK(gold.nk_residual[1] < 1e-9);
  CHECK(gold.nk_residual[2] < 1e-9);
  CHECK(gold.n[0] < 1);
}

TEST_CASE("a model's parameters follow the surface by their roles") {
  SurfaceValues s;
  s.diffuse = {0.1, 0.2, 0.3};
  s.f0 = {1.04, 0.7, -0.001};
  s.n = {2, 3, 4};
  s.k = {5, 6, 7};
  s.gloss = 0.5;
  CHECK(model_values(*find_model("lambert"), s, {}) == std::vector<double>{0.1, 0.2, 0.3});
  CHECK(model_values(*find_model("schueler-ksk"), s, {}) == std::vector<double>{1.04, 0.7, -0.001, 0.5});
  CHECK(model_values(*find_model("schueler-full"), s, {}) == std::vector<double>{2, 3, 4, 5, 6, 7, 0.5});
  CHECK(model_values(*find_model("cook-torrance"), s, {})[6] == Approx(std::sqrt(2.0 / 66)));
  CHECK(model_values(*find_model("blinn-phong"), s, {})[6] == Approx(64));
}

TEST_CASE("overrides set a parameter, one channel of it, and are refused by name and range") {
  const Model& model = *find_model("schueler-ksk");
  const SurfaceValues s;
  CHECK(model_values(model, s, {{"K", 0.5}, {"K.g", 0.25}, {"g", 1}}) ==
        std::vector<double>{0.5, 0.25, 0.5, 1});
  CHECK(test::contains(test::error_of([&] {
                         (void)model_values(model, s, {{"roughness", 0.5}});
                       }),
                       "roughness"));
  CHECK(test::contains(test::error_of([&] { (void)model_values(model, s, {{"g", 1.5}}); }), "0 to 1"));
  CHECK_THROWS_AS(model_values(model, s, {{"K", std::nan("")}}), Error);
  CHECK_THROWS_AS(model_values(model, s, {{"K.x", 0.5}}), Error);
  CHECK_THROWS_AS(model_values(*find_model("ggx-schlick"), s, {{"alpha", 0.0}}), Error);
}

TEST_CASE("every model of the registry takes every material of the sheet") {
  for (const char* id : {"gold", "fused_silica", "pmma", "silicon"}) {
    const SurfaceValues s = library_surface(id);
    for (const Model& model : models()) {
      CAPTURE(id, model.id);
      std::vector<ClampedValue> clamped;
      const auto values = model_values(model, s, {}, &clamped);
      CHECK(values.size() == model.value_count());
      for (const ClampedValue& each : clamped) CHECK(each.wanted != each.used);
    }
  }
}

TEST_CASE("scenes with numbers out of their domain are refused") {
  const auto refused = [](const std::function<void(Scene&)>& spoil) {
    Scene scene = lambert_scene();
    CHECK_NOTHROW(validate(scene));
    spoil(scene);
    CHECK_THROWS_AS(validate(scene), Error);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](Scene& s) { s.width = 0; });
  refused([](Scene& s) { s.height = 16385; });
  refused([&](Scene& s) { s.exposure = nan; });
  refused([](Scene& s) { s.exposure = -1; });
  refused([&](Scene& s) { s.surface.f0[1] = nan; });
  refused([](Scene& s) { s.surface.n = s.surface.k = {0, 0, 0}; });
  refused([](Scene& s) { s.surface.gloss = 1.01; });
  refused([](Scene& s) { s.surface.opacity = -0.1; });
  refused([](Scene& s) { s.diffuse = nullptr; });
  refused([](Scene& s) { s.diffuse_values.pop_back(); });
  refused([&](Scene& s) { s.diffuse_values[0] = nan; });
  refused([](Scene& s) { s.field_of_view_deg = 180; });
  refused([](Scene& s) {
    // A diffuse model beside a model that has a diffuse part of its own.
    for (const Model& model : models())
      if (model.kind == ModelKind::combined) s.specular = &model;
    s.specular_values = model_values(*s.specular, s.surface, {});
  });
  refused([](Scene& s) {
    s.lights.lights.push_back({});
    s.lights.lights[0].intensity = -1;
  });
  refused([](Scene& s) {
    s.lights.lights.push_back({});
    s.lights.lights[0].kind = LightKind::spot;
    s.lights.lights[0].inner_deg = 40;
  });
}

}  // namespace etak
