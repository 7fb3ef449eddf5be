// SPDX-License-Identifier: Apache-2.0
#include "core/render/engines.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/brdf/integrals/albedo.h"
#include "core/material/library.h"
#include "core/render/ambient/engine_light.h"

namespace etak {
namespace {

double red_of(const char* model, const std::vector<double>& values, const Directions& d) {
  double rgb[3];
  find_model(model)->f64(d, values.data(), rgb);
  return rgb[0];
}

Scene ball(const char* material, double roughness) {
  Scene scene;
  const auto found = MaterialLibrary::builtin().find(material);
  scene.surface = surface_of(*found, found->preferred_dataset(), {0, 0, 0}, Gloss::of_roughness(roughness));
  scene.width = scene.height = 32;
  scene.lights = default_lights();
  return exact_scene(scene);
}

}  // namespace

TEST_CASE("each engine has a model that lists leave out, and a name of its own") {
  for (const Engine& engine : engines()) {
    CHECK(find_engine(engine.id) == &engine);
    REQUIRE(find_model(engine.model) != nullptr);
    for (const Model& model : models()) CHECK(model.id != engine.model);
  }
  CHECK(find_engine("cryengine") == nullptr);
}

TEST_CASE("Unreal's, URP's and glTF's formulas at one pair of directions are those of their sources") {
  // Light and viewer 60 degrees from each other, both 30 degrees from the normal: nh = 1, lh = cos 30.
  const double c = std::sqrt(3) / 2, pi = std::numbers::pi;
  const Directions d{0.5, 0, c, -0.5, 0, c};
  const std::vector<double> values{0.3, 0.3, 0.3, 0.5, 0.5, 0.5, 0.25};  // roughness 0.5
  const double D = 1 / (pi * 0.25 * 0.25), F = 0.5 + 0.5 * std::pow(1 - c, 5);
  const double k = 1.5 * 1.5 / 8, g = c / (c * (1 - k) + k);
  const double gaussian = 0.5 + 0.5 * std::exp2((-5.55473 * c - 6.98316) * c);
  CHECK(red_of("as-unreal", values, d) == Approx(0.3 / pi + D * g * g * gaussian / (4 * c * c)));
  const double root = std::sqrt(0.0625 + 0.9375 * c * c);
  CHECK(red_of("as-gltf", values, d) == Approx((1 - F) * 0.3 / pi + F * D * 0.5 / (2 * c * root)));
  const double bracket = 0.0625 - 1 + 1.00001;
  CHECK(red_of("as-unity-urp", values, d) ==
        Approx((0.3 * 0.5 + 0.5 * 0.0625 / (bracket * bracket * c * c * 3)) / pi));
}

TEST_CASE("under even light Filament, HDRP and glTF viewers give back all of a white metal") {
  const Vec3 white{1, 1, 1};
  for (const double alpha : {0.05, 0.3, 0.8})
    for (const double nv : {0.2, 0.6, 1.0})
      for (const char* model : {"as-filament", "as-unity-hdrp", "as-gltf"})
        CHECK(engine_light(model, nv, alpha, white)->specular[1] == Approx(1).margin(1e-9));
  CHECK_FALSE(engine_light("as-blender", 0.5, 0.3, white).has_value());
  CHECK_FALSE(engine_light("ggx-schlick", 0.5, 0.3, white).has_value());
}

TEST_CASE("Unreal's masking under environments is Smith's at roughness 1, and so is the albedo") {
  for (const double angle_deg : {0.0, 45.0, 70.0}) {
    const std::vector<double> values{1, 1, 1, 1};
    AlbedoOptions options;
    options.lobe_width = 1;
    const double once =
        directional_albedo([&](const Directions& d) { return red_of("ggx-schlick-uncorrelated", values, d); },
                           angle_deg, options);
    const double nv = std::cos(angle_deg * std::numbers::pi / 180);
    CHECK(engine_light("as-unreal", nv, 1, {1, 1, 1})->specular[0] == Approx(once).margin(2e-3));
  }
}

TEST_CASE("an engine's fields hold F0 of at most 1, and Unreal's of a dielectric 0.08") {
  std::vector<ClampedValue> changed;
  SurfaceValues gold;
  gold.f0 = {1.04, 0.77, 0.34};
  CHECK(held_by(*find_engine("unreal"), gold, changed).f0 == Vec3{1, 0.77, 0.34});
  REQUIRE(changed.size() == 1);
  CHECK(changed[0].name == "F0.r");
  SurfaceValues diamond;
  diamond.f0 = {0.17, 0.17, 0.17};
  CHECK(held_by(*find_engine("unreal"), diamond, changed).f0 == Vec3{0.08, 0.08, 0.08});
  CHECK(held_by(*find_engine("gltf"), diamond, changed).f0 == diamond.f0);
}

TEST_CASE("Blender's F82 comes nearer to chromium than Schlick's F, and URP's fit is farther than Filament") {
  const Scene chromium = ball("chromium", 0.3);
  const auto mean = [&](const char* id) {
    return engine_difference(*find_engine(id), chromium, nullptr, 1).mean_de;
  };
  CHECK(mean("blender") < mean("filament"));
  CHECK(mean("filament") < mean("unity-urp"));
  const DifferencePicture off = engine_difference(*find_engine("gltf"), chromium, nullptr, 1);
  CHECK(off.max_de >= off.mean_de);
}

}  // namespace etak
