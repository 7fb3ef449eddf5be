// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "core/glsl/glsl_source.h"
#include "core/glsl/glsl_text.h"
#include "tests/gl/scenes.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
namespace fs = std::filesystem;

TEST_CASE("every formula text of the tree is in the program, byte for byte") {
  std::set<std::string> known;
  for (const GlslFile& file : glsl_files()) {
    known.insert(std::string(file.name));
    const std::string folder = file.is_formula() ? "/core/" : "/resources/";
    CHECK(slurp(source_folder() + folder + std::string(file.name)) == file.text);
  }
  for (const char* folder : {"fresnel", "brdf", "light"})
    for (const auto& entry : fs::directory_iterator(source_folder() + "/core/" + folder)) {
      if (entry.path().extension() != ".glsl") continue;
      CHECK(known.contains(std::string(folder) + "/" + entry.path().filename().string()));
    }
}

TEST_CASE("whole numbers become real ones, names and comments stay") {
  CHECK(real_literals("real m2 = 4 * n / (n + 1);") == "real m2 = 4.0 * n / (n + 1.0);");
  CHECK(real_literals("real(0.5) + 1e-12 + 2.5e+3 - 12") == "real(0.5) + 1e-12 + 2.5e+3 - 12.0");
  CHECK(real_literals("x = 2; // 2 of 3\ny = 3;") == "x = 2.0; // 2 of 3\ny = 3.0;");
}

TEST_CASE("a text brings what it calls and nothing else") {
  const std::string text = glsl_needed_by("vec3 x = f_schlick(K, c);");
  CHECK(contains(text, "real schlick_rise(real c)"));
  CHECK(contains(text, "vec3 f_schlick(vec3 f0, real c)"));
  CHECK(contains(text, "Schlick 1994"));
  CHECK_FALSE(contains(text, "fresnel_exact"));
  CHECK_FALSE(contains(text, "real f0("));  // a parameter's name is no call
  CHECK_FALSE(contains(text, "SPDX"));
  CHECK(glsl_needed_by("nothing of ours").empty());
}

TEST_CASE("a black diffuse colour leaves no diffuse term in the text") {
  const Model& model = *find_model("schueler-optimized-bounded");
  Scene scene = full_scene(model);
  CHECK(contains(glsl_text(scene).fragment, "brdf_lambert"));
  scene.surface.diffuse = {0, 0, 0};
  const GlslText text = glsl_text(scene);
  CHECK_FALSE(contains(text.fragment, "lambert"));
  CHECK_FALSE(contains(text.fragment, "diffuse"));
  REQUIRE(text.feature("diffuse") != nullptr);
  CHECK(*text.feature("diffuse") == GlslFeature{"diffuse", false, "K_d is 0"});
  CHECK(*text.feature("diffuse hemispheres") == GlslFeature{"diffuse hemispheres", false, "K_d is 0"});
}

TEST_CASE("what is off is not in the text") {
  const Model& model = *find_model("schueler-full");
  const std::string full = glsl_text(full_scene(model)).fragment,
                    bare = glsl_text(bare_scene(model)).fragment;
  for (const char* word : {"hemisphere", "sky_", "point_", "spot_", "environment", "opacity", "exposure",
                           "srgb", "camera_distance"}) {
    INFO(word);
    CHECK(contains(full, word));
    CHECK_FALSE(contains(bare, word));
  }
  for (const char* word :
       {"square_coverage", "f_schlick", "ggx", "gulbrandsen", "erf(", "_printed", "_wide", "root_encode"}) {
    INFO(word);
    CHECK_FALSE(contains(full, word));
  }
}

TEST_CASE("no light: no loop and no model") {
  Scene scene = bare_scene(*find_model("cook-torrance"));
  scene.lights.lights.clear();
  const std::string text = glsl_text(scene).fragment;
  CHECK_FALSE(contains(text, "for ("));
  CHECK_FALSE(contains(text, "brdf_"));
  CHECK_FALSE(contains(text, "Angles"));

  SECTION("a light that gives nothing counts as none") {
    Light dark;
    dark.intensity = 0;
    scene.lights.lights.push_back(dark);
    CHECK(glsl_text(scene).fragment == text);
  }
  SECTION("hemispheres alone light it without the model's text") {
    scene.lights.hemispheres.emplace();
    const std::string lit = glsl_text(scene).fragment;
    CHECK(contains(lit, "probe_share"));
    scene.lights.hemispheres->form = HemisphereForm::corrected;
    CHECK(contains(glsl_text(scene).fragment, "hemisphere_specular"));
    CHECK_FALSE(contains(lit, "brdf_"));
  }
}

TEST_CASE("moving a value keeps the text") {
  const Model& model = *find_model("ggx-schlick");
  Scene scene = full_scene(model);
  const GlslText before = glsl_text(scene);
  scene.surface.gloss = 0.3;
  scene.surface.f0 = {0.2, 0.3, 0.4};
  scene.specular_values = model_values(model, scene.surface, {});
  scene.lights.lights[0].intensity = 5;
  const GlslText after = glsl_text(scene);
  CHECK(before.fragment == after.fragment);
  CHECK(before.features == after.features);
  bool moved = false;
  for (std::size_t i = 0; i < after.uniforms.size(); ++i)
    moved = moved || before.uniforms[i].values != after.uniforms[i].values;
  CHECK(moved);
}

TEST_CASE("a model's parameters are uniforms under their names") {
  const GlslText text = glsl_text(bare_scene(*find_model("schueler-full")));
  for (const char* line :
       {"uniform vec3 specular_n;", "uniform vec3 specular_k;", "uniform float specular_g;"})
    CHECK(contains(text.fragment, line));
}

TEST_CASE("300 es: version first, then precision") {
  const std::string text = glsl_text(bare_scene(*find_model("lambert")), GlslVersion::es_300).fragment;
  CHECK(text.starts_with("#version 300 es\nprecision highp float;\n"));
}

TEST_CASE("a scene without any model is refused") {
  CHECK(contains(error_of([] { (void)glsl_text(Scene{}); }), "no model"));
}

TEST_CASE("every variable of a shader is read, and only lobes that know a tangent build one") {
  const std::regex comment("//[^\n]*"), declared(R"((?:real|float|vec[234]|[A-Z]\w+) (\w+) = )"),
      word(R"([A-Za-z_]\w*)");
  std::set<std::string> framed;
  for (const Model& model : models())
    for (const Variant& variant : variants(model)) {
      const std::string text = std::regex_replace(glsl_text(variant.scene).fragment, comment, std::string());
      std::multiset<std::string> words;
      for (std::sregex_iterator each(text.begin(), text.end(), word), end; each != end; ++each)
        words.insert(each->str());
      for (std::sregex_iterator each(text.begin(), text.end(), declared), end; each != end; ++each) {
        INFO(model.id << ", " << variant.name << ": " << each->str());
        CHECK(words.count((*each)[1].str()) > 1);
      }
      // Area lights take the same direction where viewer and normal leave theirs open.
      if (contains(text, "vec3 t = tangent_of(")) framed.insert(std::string(model.id));
    }
  CHECK(framed == std::set<std::string>{"ashikhmin-shirley", "ashikhmin-shirley-specular"});
}
