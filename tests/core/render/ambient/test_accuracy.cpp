// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/accuracy.h"

#include <catch2/catch.hpp>

#include "core/brdf/models.h"
#include "core/light/studio.h"
#include "core/material/library.h"
#include "core/render/cpu_renderer.h"
#include "core/study/ambient_pictures.h"
#include "core/study/sphere_pictures.h"
#include "tests/support.h"

namespace etak {

TEST_CASE("every model that mirrors has an error under an environment, at every gloss") {
  for (const Model& model : models()) {
    CAPTURE(model.id);
    for (const bool refined : {false, true})
      for (const double gloss : {0.0, 0.2, 0.65, 1.0}) {
        const auto off = ambient_accuracy(model.id, gloss, refined);
        CHECK(off.has_value() == (model.kind != ModelKind::diffuse));
        if (!off) continue;
        CHECK(off->mean > 0);
        CHECK(off->picture >= off->mean);
        CHECK(off->p99 >= off->picture);
      }
  }
  CHECK_FALSE(ambient_accuracy("microfacet:ggx,f82,kelemen", 0.5, false));
  const auto a = *ambient_accuracy("ggx-schlick", 0.5, false),
             b = *ambient_accuracy("ggx-schlick", 0.8, false);
  CHECK(ambient_accuracy("ggx-schlick", 0.65, false)->mean == Approx((a.mean + b.mean) / 2));
  CHECK(test::contains(ambient_accuracy_text("ggx-schlick", 0.5, false), "dE2000"));
  CHECK(ambient_accuracy("ggx-schlick", 0.5, true)->p99 < a.p99);
}

TEST_CASE("the table of errors under an environment is what the pictures have", "[slow]") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  constexpr int side = 32;
  for (const double gloss : {0.5, 0.8}) {
    double sums[2] = {0, 0}, count = 0;  // of the moving and of the refined picture
    for (const NamedStudio& studio : named_studios()) {
      const auto environment = studio_environment(std::string(studio.name), 1, 2);
      std::vector<Scene> scenes;
      for (const char* material : {"gold", "osmium", "water"}) {
        scenes.push_back(sphere_scene(*find_model("ggx-schlick"),
                                      sphere_material(library, material, {0, 0, 0}), gloss, side));
        scenes.back().lights = {};
        scenes.back().background = {0, 0, 0};
      }
      const auto truths = ambient_truths(scenes, *environment, 1024, 2);
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        for (const bool refined : {false, true}) {
          Image shown;
          scenes[i].refined = refined;
          render_cpu(scenes[i], environment.get(), 2, Precision::f32, shown);
          sums[refined] += ambient_difference(truths[i], shown).mean;
        }
        ++count;
      }
    }
    for (const bool refined : {false, true}) {
      CAPTURE(gloss, refined);
      CHECK(sums[refined] / count ==
            Approx(ambient_accuracy("ggx-schlick", gloss, refined)->mean).epsilon(0.25).margin(0.1));
    }
  }
}

}  // namespace etak
