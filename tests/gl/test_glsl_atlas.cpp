// SPDX-License-Identifier: Apache-2.0
// Shaders for what `etak pack` lists: without what a material does not need.
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>

#include "core/glsl/glsl_text.h"
#include "tests/gl/scenes.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

TextureUse use(std::vector<std::string> defines) {
  return texture_use(defines);
}

Scene plain_scene(const char* model) {
  Scene scene = bare_scene(*find_model(model));
  scene.diffuse = find_model("lambert");
  scene.diffuse_values = {0.4, 0.3, 0.2};
  scene.surface.diffuse = {0.4, 0.3, 0.2};
  return scene;
}

// Every set of defines that core/atlas/defines.cpp can give.
std::vector<std::vector<std::string>> all_defines() {
  std::vector<std::vector<std::string>> out;
  for (const char* diffuse : {"", "ETAK_DIFFUSE_TEXTURE", "ETAK_NO_DIFFUSE"})
    for (const char* specular : {"", "ETAK_SPECULAR_TEXTURE", "ETAK_SCALAR_F0"})
      for (const char* gloss : {"", "ETAK_GLOSS_TEXTURE"})
        for (const char* alpha : {"", "ETAK_ALPHA_TEST", "ETAK_ALPHA_BLEND"})
          for (const char* fetched : {"", "ETAK_ALPHA_TEXTURE"}) {
            if (*alpha == 0 && *fetched != 0) continue;
            auto& set = out.emplace_back();
            for (const char* each : {diffuse, specular, gloss, alpha, fetched})
              if (*each != 0) set.emplace_back(each);
          }
  out.push_back({"ETAK_SCALAR_F0", "ETAK_GLOSS_TEXTURE", "ETAK_GLOSS_IN_RED"});
  out.push_back(
      {"ETAK_SPECULAR_TEXTURE", "ETAK_SCALAR_F0", "ETAK_GLOSS_TEXTURE", "ETAK_F0_GLOSS_IN_RED_GREEN"});
  out.push_back({"ETAK_GLOSS_TEXTURE", "ETAK_GLOSS_APART"});
  out.push_back({"ETAK_DIFFUSE_TEXTURE", "ETAK_SPECULAR_TEXTURE", "ETAK_GLOSS_TEXTURE", "ETAK_ALPHA_BLEND",
                 "ETAK_ALPHA_TEXTURE", "ETAK_ALPHA_APART", "ETAK_GLOSS_APART"});
  out.push_back({"ETAK_GLOSS_TEXTURE", "ETAK_SPECULAR_GLOSS_TAIL"});
  out.push_back({"ETAK_DIFFUSE_TEXTURE", "ETAK_SPECULAR_TEXTURE", "ETAK_GLOSS_TEXTURE", "ETAK_GLOSS_APART",
                 "ETAK_DIFFUSE_ALPHA_TAIL", "ETAK_SPECULAR_GLOSS_TAIL"});
  return out;
}

}  // namespace

TEST_CASE("a shader holds no fetch, test or texture that the defines do not ask for") {
  const Scene scene = plain_scene("schueler-optimized");
  const std::string all =
      glsl_text(scene, use({"ETAK_DIFFUSE_TEXTURE", "ETAK_SPECULAR_TEXTURE", "ETAK_GLOSS_TEXTURE",
                            "ETAK_ALPHA_TEST", "ETAK_ALPHA_TEXTURE"}))
          .fragment;
  for (const char* what : {"sampler2D diffuse_alpha", "sampler2D specular_gloss", "discard", "texel_gloss",
                           "texel_f0", "texel_diffuse"})
    CHECK(contains(all, what));
  CHECK_FALSE(contains(all, "uniform vec3 specular_K"));

  const std::string none = glsl_text(scene, use({"ETAK_NO_DIFFUSE", "ETAK_SCALAR_F0"})).fragment;
  for (const char* what : {"sampler2D", "texture(", "discard", "texel_", "region_"}) {
    INFO(what);
    CHECK_FALSE(contains(none, what));
  }
  CHECK(contains(none, "uniform float specular_K"));

  const std::string gloss_only = glsl_text(scene, use({"ETAK_GLOSS_TEXTURE"})).fragment;
  CHECK(contains(gloss_only, "sampler2D specular_gloss"));
  CHECK_FALSE(contains(gloss_only, "diffuse_alpha"));
  CHECK(contains(gloss_only, "uniform vec3 specular_K"));
}

TEST_CASE("defines that nobody lists, and models that textures cannot feed, are refused by name") {
  CHECK(contains(error_of([] { (void)use({"ETAK_DIFUSE_TEXTURE"}); }), "ETAK_DIFUSE_TEXTURE"));
  const Scene exact = bare_scene(*find_model("ggx-exact"));
  CHECK(contains(error_of([&] { (void)glsl_text(exact, use({"ETAK_SPECULAR_TEXTURE"})); }), "ggx-exact"));
  CHECK_NOTHROW(glsl_text(exact, use({"ETAK_GLOSS_TEXTURE"})));
}

TEST_CASE("glslangValidator takes the shader of every set of defines") {
  if (std::system("glslangValidator --version >/dev/null 2>&1") != 0) {
    std::puts("skipped: glslangValidator is not installed (Debian: glslang-tools)");
    return;
  }
  const TempFolder folder;
  std::string files;
  std::size_t count = 0;
  for (const char* model : {"schueler-optimized", "schueler-simplified", "ggx-schlick", "blinn-phong"})
    for (const auto& defines : all_defines())
      for (const GlslVersion version : {GlslVersion::core_330, GlslVersion::es_300}) {
        TextureUse textures = use(defines);
        for (TextureUse::Place& place : textures.places) place.rotated = count % 2 == 1;
        // Every third material has its parts at places of their own.
        for (std::size_t p = 0; p < textures.places.size() && count % 3 == 2; ++p)
          textures.places[p].region = {0.25 * static_cast<double>(p), 0, 0.25, p == 3 ? 0 : 0.5};
        if (count % 3 == 1) textures.gloss_form = GlossForm::one_minus_roughness;
        const std::string file = folder.file(std::to_string(count++) + ".frag");
        spit(file, glsl_text(plain_scene(model), textures, version).fragment);
        files += " " + file;
      }
  const int status = std::system(("glslangValidator" + files + " >" + folder.file("log") + " 2>&1").c_str());
  const std::string log = slurp(folder.file("log"));
  INFO(count << " texts\n" << log.substr(0, 4000));
  CHECK(status == 0);
  CHECK_FALSE(contains(log, "ERROR"));
  CHECK_FALSE(contains(log, "WARNING"));
}
