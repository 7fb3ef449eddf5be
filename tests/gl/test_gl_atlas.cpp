// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/color/srgb.h"
#include "core/glsl/gl_context.h"
#include "core/glsl/gl_objects.h"
#include "core/glsl/gl_runner.h"
#include "core/glsl/texture_fetch.h"
#include "tests/gl/gl_here.h"
#include "tests/gl/scenes.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int side = 32;

// A texture whose channels hold one code each where `codes` has one (-1: noise).
Image8 texture(const std::array<int, 4>& codes, unsigned seed) {
  std::mt19937 random(seed);
  Image8 out(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        out.at(x, y)[c] =
            static_cast<std::uint8_t>(codes[c] < 0 ? random() % 256 : static_cast<unsigned>(codes[c]));
  return out;
}

double linear(int code) {
  return srgb_decode(code / 255.0);
}

Scene scene_with(const char* model, const std::array<int, 4>& a, const std::array<int, 4>& b) {
  Scene scene = bare_scene(*find_model(model));
  scene.width = scene.height = 96;
  scene.diffuse = find_model("lambert");
  SurfaceValues& surface = scene.surface;
  for (std::size_t c = 0; c < 3; ++c) {
    surface.diffuse[c] = a[c] < 0 ? 0.5 : linear(a[c]);
    surface.f0[c] = b[c] < 0 ? 0.04 : linear(b[c]);
  }
  surface.gloss = b[3] < 0 ? 0.5 : b[3] / 255.0;
  surface.opacity = a[3] < 0 ? 1 : a[3] / 255.0;
  scene.specular_values = model_values(*scene.specular, surface, {});
  scene.diffuse_values = model_values(*scene.diffuse, surface, {});
  return scene;
}

// Largest difference of two pictures in 8-bit sRGB codes.
int most_codes(const Image& p, const Image& q) {
  int most = 0;
  for (std::size_t i = 0; i < p.values.size(); ++i)
    if (i % 4 != 3)
      most = std::max(most, std::abs(int{srgb_u8(std::clamp(double{p.values[i]}, 0.0, 1.0))} -
                                     int{srgb_u8(std::clamp(double{q.values[i]}, 0.0, 1.0))}));
  return most;
}

struct Case {
  const char* what;
  std::array<int, 4> a, b;  // codes of the two textures, -1: noise
  std::vector<std::string> defines;
};

}  // namespace

TEST_CASE("a shader without what is constant draws the picture of the one that fetches everything") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const std::vector<Case> cases{
      {"only gloss varies", {180, 90, 60, 255}, {56, 56, 56, -1}, {"ETAK_SCALAR_F0", "ETAK_GLOSS_TEXTURE"}},
      {"a metal of one colour",
       {0, 0, 0, 255},
       {255, 220, 150, -1},
       {"ETAK_NO_DIFFUSE", "ETAK_GLOSS_TEXTURE"}},
      {"nothing varies", {120, 120, 120, 255}, {60, 60, 60, 190}, {"ETAK_SCALAR_F0"}},
      {"diffuse varies", {-1, -1, -1, 255}, {60, 60, 60, 100}, {"ETAK_DIFFUSE_TEXTURE", "ETAK_SCALAR_F0"}},
      {"F0 varies", {10, 60, 90, 255}, {-1, -1, -1, 128}, {"ETAK_SPECULAR_TEXTURE"}}};
  for (const char* model : {"schueler-optimized-bounded", "schueler-simplified", "ggx-schlick"})
    for (const Case& each : cases) {
      const Image8 a = texture(each.a, 1), b = texture(each.b, 2);
      const Scene scene = scene_with(model, each.a, each.b);
      const Image all = gl->render(scene, TextureUse{}, a, b);
      const Image few = gl->render(scene, texture_use(each.defines), a, b);
      INFO(model << ", " << each.what);
      CHECK(most_codes(all, few) <= 1);
      // And the picture is no constant by mistake.
      CHECK(most_codes(all, Image(scene.width, scene.height, 4)) > 20);
    }
}

TEST_CASE("an opaque mask needs no alpha test, and a mask cuts what it hides") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  TextureUse tested;
  tested.fetch_alpha = true;
  tested.alpha = TextureUse::Alpha::test;
  const Image8 b = texture({60, 60, 60, 150}, 2);
  const std::array<int, 4> opaque{-1, -1, -1, 255}, hidden{-1, -1, -1, 100};
  const Scene scene = scene_with("schueler-optimized-bounded", opaque, {60, 60, 60, 150});
  CHECK(most_codes(gl->render(scene, tested, texture(opaque, 1), b),
                   gl->render(scene, TextureUse{}, texture(opaque, 1), b)) == 0);
  const Image empty = gl->render(scene, tested, texture(hidden, 1), b);
  const int background = srgb_u8(scene.background[0]);
  for (int y = 30; y < 60; ++y) CHECK(int{srgb_u8(double{empty.at(48, y)[0]})} == background);
}

TEST_CASE(
    "a texture of gloss alone, or of a grey F0 with gloss, draws the picture of the one with all channels") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const std::array<int, 4> a{90, 60, 30, 255};
  for (const bool gloss_alone : {true, false}) {
    INFO((gloss_alone ? "gloss alone" : "F0 and gloss"));
    Image8 four = texture({gloss_alone ? 56 : -1, 56, 56, -1}, 3), few(side, side, 4);
    for (std::size_t i = 0; i < four.values.size(); i += 4) {
      std::uint8_t* texel = &four.values[i];
      texel[1] = texel[2] = texel[0];
      few.values[i] = gloss_alone ? texel[3] : texel[0];
      few.values[i + 1] = gloss_alone ? 0 : texel[3];
    }
    const Scene scene = scene_with("schueler-optimized-bounded", a, {56, 56, 56, -1});
    const std::vector<std::string> defines =
        gloss_alone ? std::vector<std::string>{"ETAK_SCALAR_F0", "ETAK_GLOSS_TEXTURE", "ETAK_GLOSS_IN_RED"}
                    : std::vector<std::string>{"ETAK_SPECULAR_TEXTURE", "ETAK_SCALAR_F0",
                                               "ETAK_GLOSS_TEXTURE", "ETAK_F0_GLOSS_IN_RED_GREEN"};
    TextureUse all;
    all.diffuse = false;
    CHECK(most_codes(gl->render(scene, all, texture(a, 1), four),
                     gl->render(scene, texture_use(defines), texture(a, 1), few)) <= 1);
  }
}

TEST_CASE("gloss and opacity in textures of their own draw the picture of those in the fourth channels") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const std::array<int, 4> channels{-1, -1, -1, -1};
  const Image8 a = texture(channels, 1), b = texture(channels, 2);
  const Scene scene = scene_with("schueler-optimized-bounded", {90, 60, 30, 255}, {56, 56, 56, 128});
  for (const char* mode : {"ETAK_ALPHA_BLEND", "ETAK_ALPHA_TEST"}) {
    CAPTURE(mode);
    std::vector<std::string> defines{"ETAK_DIFFUSE_TEXTURE", "ETAK_SPECULAR_TEXTURE", "ETAK_GLOSS_TEXTURE",
                                     mode, "ETAK_ALPHA_TEXTURE"};
    const Image together = gl->render(scene, texture_use(defines), a, b);
    defines.insert(defines.end(), {"ETAK_ALPHA_APART", "ETAK_GLOSS_APART"});
    CHECK(gl->render(scene, texture_use(defines), a, b).values == together.values);
  }
}

namespace {

// Levels of a texture of 64 x 64 texels from `first` to before `end`, each of its own colours, filtered between levels.
GLuint levels_of_noise(int unit, int first, int end) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, id);
  for (int l = first; l < end; ++l) {
    Image8 level(64 >> l, 64 >> l, 4);
    std::mt19937 random(static_cast<unsigned>(l));
    for (std::uint8_t& value : level.values) value = static_cast<std::uint8_t>(random() % 256);
    glTexImage2D(GL_TEXTURE_2D, l - first, GL_SRGB8_ALPHA8, level.width, level.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, level.values.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, end - first - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return id;
}

}  // namespace

TEST_CASE("levels that lie in two textures are filtered as those of one, at every size") {
  if (gl_here() == nullptr) return;
  const GlContext context;
  context.make_current();
  constexpr int first = 3, all = 7;
  const GLuint textures[]{levels_of_noise(0, 0, all), levels_of_noise(1, 0, first),
                          levels_of_noise(2, first, all)};
  glActiveTexture(GL_TEXTURE3);  // what is drawn into takes the active unit
  std::array<std::vector<float>, 2> pictures;
  for (const int pixels : {1, 2, 3, 5, 8, 11, 16, 23, 32, 64, 100}) {
    CAPTURE(pixels);
    for (const bool apart : {false, true}) {
      TextureUse use;
      use.specular = use.gloss = false;
      use.diffuse_tail = apart;
      const TextureFetch fetch = texture_fetch(use, 1);
      const gl::Program program(
          "#version 330 core\nout vec2 at;\nvoid main() {\n"
          "  at = vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0;\n  gl_Position = vec4(at, 0, 1);\n}\n",
          "#version 330 core\nin vec2 at;\nout vec4 colour;\n"
          "uniform vec2 region_corner, region_size;\n" +
              fetch.code + "void main() {\n  fetch(at);\n  colour = vec4(texel_diffuse, 1);\n}\n");
      glUseProgram(program.id());
      for (const GlslUniform& uniform : fetch.uniforms) program.set(uniform);
      program.set_sampler("diffuse_alpha", apart ? 1 : 0);
      program.set_sampler("diffuse_alpha_tail", 2);
      const gl::Target target(GL_RGBA32F, pixels, pixels);
      GLuint nothing = 0;
      glGenVertexArrays(1, &nothing);
      glBindVertexArray(nothing);
      glDrawArrays(GL_TRIANGLES, 0, 3);
      auto& picture = pictures[apart ? 1 : 0];
      picture.resize(static_cast<std::size_t>(4 * pixels * pixels));
      glReadPixels(0, 0, pixels, pixels, GL_RGBA, GL_FLOAT, picture.data());
      glDeleteVertexArrays(1, &nothing);
    }
    double most = 0;
    for (std::size_t i = 0; i < pictures[0].size(); ++i)
      most = std::max(most, std::abs(double{pictures[0][i]} - double{pictures[1][i]}));
    // llvmpipe takes the shares of two levels in steps of a 256th.
    CHECK(most < 0.01);
  }
  glDeleteTextures(3, textures);
}

TEST_CASE("alpha that blends is the same from a texture and from a uniform") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const std::array<int, 4> a{-1, -1, -1, 102}, b{60, 60, 60, 150};
  const Scene scene = scene_with("schueler-optimized-bounded", a, b);
  TextureUse all;
  all.fetch_alpha = true;
  all.alpha = TextureUse::Alpha::blend;
  const std::vector<std::string> defines{"ETAK_DIFFUSE_TEXTURE", "ETAK_SCALAR_F0", "ETAK_ALPHA_BLEND"};
  CHECK(most_codes(gl->render(scene, all, texture(a, 1), texture(b, 2)),
                   gl->render(scene, texture_use(defines), texture(a, 1), texture(b, 2))) <= 1);
}
