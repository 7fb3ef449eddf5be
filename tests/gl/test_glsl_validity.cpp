// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/glsl/glsl_text.h"
#include "tests/gl/scenes.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("glslangValidator takes every model with everything on, everything off and each feature toggled") {
  if (std::system("glslangValidator --version >/dev/null 2>&1") != 0) {
    std::puts("skipped: glslangValidator is not installed (Debian: glslang-tools)");
    return;
  }
  std::vector<const Model*> all;
  for (const Model& model : models()) all.push_back(&model);
  // Terms that no row of the registry holds.
  for (const char* id :
       {"microfacet:beckmann-printed,schueler,kelemen", "microfacet:schueler,schlick,implicit",
        "microfacet:abc-printed,schlick,cook-torrance", "microfacet:ggx,curve,smith-ggx-height"}) {
    REQUIRE(find_model(id) != nullptr);
    all.push_back(find_model(id));
  }
  for (const Model* model : all) {
    const TempFolder folder;
    std::string files;
    std::size_t count = 0;
    for (const GlslVersion version : {GlslVersion::core_330, GlslVersion::es_300}) {
      const std::string ending = version == GlslVersion::core_330 ? ".330.frag" : ".300es.frag";
      for (const Variant& variant : variants(*model)) {
        const std::string file = folder.file(variant.name + ending);
        spit(file, glsl_text(variant.scene, version).fragment);
        files += " " + file;
        ++count;
      }
      const std::string evaluation = folder.file("evaluation" + ending);
      spit(evaluation, glsl_evaluation_text(*model,
                                            variants(*model)[0].scene.specular == nullptr
                                                ? variants(*model)[0].scene.diffuse_values
                                                : variants(*model)[0].scene.specular_values,
                                            version)
                           .fragment);
      files += " " + evaluation;
    }
    const auto [output, status] = run("glslangValidator" + files);
    INFO(model->id << ": " << count << " texts\n" << output.substr(0, 4000));
    CHECK(status == 0);
    CHECK_FALSE(contains(output, "ERROR"));
    CHECK_FALSE(contains(output, "WARNING"));
  }
  SECTION("and both vertex texts") {
    const TempFolder folder;
    const Scene scene = bare_scene(*find_model("lambert"));
    spit(folder.file("a.vert"), glsl_text(scene).vertex);
    spit(folder.file("b.vert"), glsl_text(scene, GlslVersion::es_300).vertex);
    const auto [output, status] =
        run("glslangValidator " + folder.file("a.vert") + " " + folder.file("b.vert"));
    INFO(output);
    CHECK(status == 0);
  }
}
