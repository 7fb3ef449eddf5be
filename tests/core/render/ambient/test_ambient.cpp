// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/ambient.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/brdf/integrals/albedo.h"
#include "core/color/delta_e.h"
#include "core/material/library.h"
#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

constexpr int side = 48;

SurfaceValues osmium(double gloss) {
  static const auto material = MaterialLibrary::builtin().find("osmium");
  return surface_of(*material, material->preferred_dataset(), {0, 0, 0}, gloss);
}

Scene scene_of(const Model& model, const SurfaceValues& surface) {
  Scene scene;
  scene.width = scene.height = side;
  scene.surface = surface;
  (model.kind == ModelKind::diffuse ? scene.diffuse : scene.specular) = &model;
  (model.kind == ModelKind::diffuse ? scene.diffuse_values : scene.specular_values) =
      model_values(model, surface, {});
  scene.lights = {};
  scene.background = {0, 0, 0};
  return scene;
}

Image drawn(const Scene& scene, const Environment& environment) {
  Image out;
  render_cpu(scene, &environment, 2, Precision::f32, out);
  return out;
}

// CIEDE2000 of two greys.
double difference(double a, double b) {
  const auto lab = [](double y) {
    return to_lab(LinearRgb{std::min(y, 1.0), std::min(y, 1.0), std::min(y, 1.0)});
  };
  return delta_e2000(lab(a), lab(b));
}

// The angle between normal and viewer at a pixel of the middle row.
double angle_deg(int column) {
  return std::asin(std::abs((column + 0.5 - side / 2.0) * 2.2 / side)) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("a white surrounding is right to dE 0.5 for every model, osmium at gloss 1 included", "[slow]") {
  const Environment white(Image(16, 8, 3, 1.0f), 1, "white", 2);
  for (const Model& model : models())
    for (const double gloss : {0.2, 0.6, 1.0}) {
      const SurfaceValues surface = osmium(gloss);
      Scene scene = scene_of(model, surface);
      if (model.kind == ModelKind::diffuse) {
        scene.surface.diffuse = {0.6, 0.6, 0.6};
        scene.diffuse_values = model_values(model, scene.surface, {});
      }
      const std::vector<double>& values =
          model.kind == ModelKind::diffuse ? scene.diffuse_values : scene.specular_values;
      AlbedoOptions options;
      options.lobe_width = alpha_of_gloss(gloss);
      options.error = 1e-4;
      for (const int column : {side / 2, side / 2 + 8, side / 2 + 14, side / 2 + 18, side / 2 + 20}) {
        const double truth = directional_albedo(
            [&](const Directions& d) {
              double rgb[3];
              model.f64(d, values.data(), rgb);
              return rgb[1];
            },
            angle_deg(column), options);
        for (const bool refined : {false, true}) {
          scene.refined = refined;
          const Image picture = drawn(scene, white);
          // The middle row lies half a pixel beside the middle.
          const double shown =
              double((picture.at(column, side / 2)[1] + picture.at(column, side / 2 - 1)[1]) / 2);
          CAPTURE(model.id, gloss, refined, angle_deg(column), truth, shown);
          CHECK(difference(truth, shown) < 0.5);
        }
      }
    }
}

TEST_CASE("models that differ give pictures that differ under an environment") {
  const auto studio = quick_studio_environment("studio", 1, 2);
  for (const double gloss : {0.3, 0.8}) {
    std::vector<std::pair<const Model*, Image>> pictures;
    for (const Model& model : models())
      if (model.kind != ModelKind::diffuse)
        pictures.emplace_back(&model, drawn(scene_of(model, osmium(gloss)), *studio));
    for (std::size_t i = 0; i < pictures.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto& [a, one] = pictures[i];
        const auto& [b, other] = pictures[j];
        double models_differ = 0;
        for (const double tilt : {0.1, 0.5, 0.9}) {
          double f[3], g[3];
          const Directions d{-std::sin(tilt),      0, std::cos(tilt),
                             std::sin(1.1 * tilt), 0, std::cos(1.1 * tilt)};
          a->f64(d, model_values(*a, osmium(gloss), {}).data(), f);
          b->f64(d, model_values(*b, osmium(gloss), {}).data(), g);
          models_differ = std::max(models_differ, std::abs(f[1] / g[1] - 1));
        }
        CAPTURE(a->id, b->id, gloss, models_differ);
        if (models_differ > 0.01) CHECK(one.values != other.values);
      }
  }
}

TEST_CASE("a table of textures is that of the surface at the F0 and the gloss of its nodes") {
  const Model& model = *find_model("ggx-schlick");
  SurfaceValues surface;
  surface.gloss = 0.5;
  for (const double f0 : {0.04, 0.5, 1.0}) {
    surface.f0 = {f0, f0, f0};
    const auto plain = ambient_table(scene_of(model, surface), {});
    const auto of_textures = ambient_table(scene_of(model, surface), {true, true});
    REQUIRE(of_textures->of_f0);
    REQUIRE(of_textures->glosses == 5);
    // Both have nodes at nv = 1; row 2 is that of gloss 1/2.
    const float* c = of_textures->albedo.data() + 3 * (3 * of_textures->views - 1);
    CHECK(double{c[0]} + f0 * (double{c[1]} + f0 * double{c[2]}) ==
          Approx(double{plain->albedo[plain->albedo.size() - 1]}).epsilon(1e-3));
  }
}

TEST_CASE("what does not follow a texture has no rows for it, and anisotropic lobes are told") {
  CHECK(ambient_table(scene_of(*find_model("ggx-exact"), osmium(0.5)), {true, false})->glosses == 1);
  CHECK_FALSE(ambient_table(scene_of(*find_model("ggx-exact"), osmium(0.5)), {true, false})->of_f0);
  CHECK(ambient_table(scene_of(*find_model("abc-schlick"), osmium(0.5)), {true, true})->glosses == 1);
  Scene scene = scene_of(*find_model("ashikhmin-shirley-specular"), osmium(0.5));
  CHECK_FALSE(ambient_table(scene, {})->anisotropic);
  scene.specular_values.back() = 4;
  CHECK(ambient_table(scene, {})->anisotropic);
}

TEST_CASE("the body of a Lambert surface is its colour, that of others has an albedo of its own") {
  CHECK(ambient_table(scene_of(*find_model("lambert"), {}), {})->plain_body);
  for (const char* id : {"oren-nayar", "lambert-tradeoff", "ashikhmin-shirley-diffuse"}) {
    CAPTURE(id);
    CHECK_FALSE(ambient_table(scene_of(*find_model(id), {}), {})->plain_body);
  }
}

TEST_CASE(
    "hemispheres take Schueler's formula for his models and that of the model else, unless one is asked for") {
  Scene scene = scene_of(*find_model("schueler-ksk"), osmium(0.5));
  scene.lights.hemispheres.emplace();
  CHECK(hemisphere_form(scene) == HemisphereForm::corrected);
  scene.specular = find_model("ggx-schlick");
  CHECK(hemisphere_form(scene) == HemisphereForm::model);
  scene.lights.hemispheres->form = HemisphereForm::wide;
  CHECK(hemisphere_form(scene) == HemisphereForm::wide);
}

}  // namespace etak
