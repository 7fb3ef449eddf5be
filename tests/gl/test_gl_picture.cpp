// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "core/color/srgb.h"
#include "core/render/cpu_renderer.h"
#include "core/render/display.h"
#include "tests/gl/gl_here.h"
#include "tests/gl/scenes.h"

using namespace etak;
using namespace etak::test;

namespace {

const Environment& sky() {
  static const Environment environment(environment_picture(*find_studio("studio"), 128), 1, "studio", 2);
  return environment;
}

// Largest difference of two pictures relative to max(|a|, 0.01), and where.
struct Difference {
  double most = 0;
  int x = 0, y = 0, channel = 0;
};
Difference difference(const Image& a, const Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  REQUIRE(a.channels == b.channels);
  Difference out;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < a.channels; ++c) {
        const double p = double{a.at(x, y)[static_cast<std::size_t>(c)]},
                     q = double{b.at(x, y)[static_cast<std::size_t>(c)]};
        const double error = std::abs(p - q) / std::max(std::abs(p), 0.01);
        if (!(error <= out.most)) out = {error, x, y, c};
      }
  return out;
}

}  // namespace

TEST_CASE("GL draws the CPU's picture: every feature of a scene") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  for (const char* id : {"schueler-optimized-bounded", "ashikhmin-shirley-specular", "lambert", "blinn-phong",
                         "microfacet:ggx,curve,smith-ggx-height"})
    for (const Variant& variant : variants(*find_model(id))) {
      Scene scene = variant.scene;
      scene.width = 150;
      scene.height = 101;
      const bool with_sky = !scene.lights.environment.empty();
      Image expected;
      render_cpu(scene, with_sky ? &sky() : nullptr, 2, Precision::f64, expected);
      const Difference found = difference(expected, gl->render(scene, with_sky ? &sky() : nullptr));
      INFO(id << ", " << variant.name << ": column " << found.x << " row " << found.y << " channel "
              << found.channel);
      // The look-up of an environment map goes through atan and the driver's filter.
      CHECK(found.most < (with_sky ? 2e-3 : 1e-3));
    }
}

TEST_CASE("GL draws the CPU's refined picture within two codes") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  for (const char* id : {"ggx-schlick", "oren-nayar", "blinn-phong", "microfacet:ggx,curve,smith-ggx-height"})
    for (const Variant& variant : variants(*find_model(id))) {
      Scene scene = variant.scene;
      const bool with_sky = !scene.lights.environment.empty();
      scene.refined = true;
      scene.width = 60;
      scene.height = 41;
      Image expected;
      render_cpu(scene, with_sky ? &sky() : nullptr, 2, Precision::f32, expected);
      const Image drawn = gl->render(scene, with_sky ? &sky() : nullptr);
      const Image8 a = to_codes(expected, scene.exposure, scene.transfer, scene.tone),
                   b = to_codes(drawn, scene.exposure, scene.transfer, scene.tone);
      int most = 0;
      for (std::size_t i = 0; i < a.values.size(); ++i)
        most = std::max(most, std::abs(int(a.values[i]) - int(b.values[i])));
      INFO(id << ", " << variant.name);
      CHECK(most <= 2);
    }
}

TEST_CASE("GL draws the CPU's picture: every model") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  for (const Model& model : models()) {
    Scene scene = bare_scene(model);
    scene.width = scene.height = 96;
    Image expected;
    render_cpu(scene, nullptr, 2, Precision::f64, expected);
    const Difference found = difference(expected, gl->render(scene));
    INFO(model.id << ": column " << found.x << " row " << found.y << " channel " << found.channel);
    CHECK(found.most < 1e-3);
  }
}

TEST_CASE("GL's tone curves show the CPU's codes") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  for (const Vec3& color : {Vec3{0.18, 0.18, 0.18}, Vec3{0.03, 0.5, 0.2}, Vec3{1.02, 0.78, 0.34},
                            Vec3{9, 2, 0.1}, Vec3{0, 0, 0.004}})
    for (const Tone tone : {Tone::neutral, Tone::agx_like, Tone::filament, Tone::false_color}) {
      const std::string function = tone == Tone::neutral    ? "tone_neutral"
                                   : tone == Tone::agx_like ? "tone_agx_like"
                                   : tone == Tone::filament ? "tone_filament"
                                                            : "tone_false_color";
      Image pixel(1, 1, 4);
      std::string arguments;
      for (std::size_t c = 0; c < 3; ++c) {
        pixel.values[c] = static_cast<float>(color[c]);
        arguments += (c == 0 ? "real(" : ", real(") + std::to_string(color[c]) + ")";
      }
      const Image8 codes = to_codes(pixel, 1, Transfer::srgb, tone);
      for (std::size_t c = 0; c < 3; ++c) {
        const std::string call = function + "(vec3(" + arguments + "))." + "xyz"[c];
        INFO(call);
        CHECK(255 * srgb_encode(double{gl->evaluate(call)}) == Approx(codes.values[c]).margin(0.6));
      }
    }
}

TEST_CASE("the GL's own clock runs while it draws, and stays within the time of the whole call") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  const Scene scene = bare_scene(*find_model("ggx-schlick"));
  const GlRunner::FrameTime time = gl->frame_time(scene, nullptr, 5);
  CHECK(time.least_ms > 0);
  CHECK(time.median_ms >= time.least_ms);
  if (!time.gpu_median_ms) return;
  CHECK(*time.gpu_least_ms >= 0);
  CHECK(*time.gpu_least_ms <= *time.gpu_median_ms);
  // Two clocks: a little slack.
  CHECK(*time.gpu_median_ms <= 1.1 * time.median_ms + 0.1);
  std::optional<double> alone;
  gl->render(scene, nullptr, &alone);
  REQUIRE(alone);
  CHECK(*alone >= 0);
}

// Prints milliseconds per frame: etak_gl_tests "[.frame-time]".
TEST_CASE("frame times of every model at 512 x 512 with 4 lights", "[.frame-time]") {
  GlRunner* gl = gl_here();
  if (gl == nullptr) return;
  std::printf("%s, OpenGL %s%s\n", gl->info().renderer.c_str(), gl->info().version.c_str(),
              gl->info().software ? ": a software rasteriser" : "");
  for (const Model& model : models()) {
    Scene scene = bare_scene(model);
    scene.transfer = Transfer::srgb;
    scene.lights.lights.resize(4, scene.lights.lights[0]);
    for (std::size_t i = 1; i < 4; ++i)
      scene.lights.lights[i].direction = {i == 1 ? 0.6 : 0.0, i == 2 ? 0.6 : 0.0, i == 3 ? -1.0 : -0.8};
    const GlRunner::FrameTime time = gl->frame_time(scene, nullptr, 40);
    std::printf("%-30s %6.2f ms least, %6.2f median, %6.1f first", std::string(model.id).c_str(),
                time.least_ms, time.median_ms, time.compile_ms);
    if (time.gpu_median_ms)
      std::printf("; by the GL's clock %6.2f least, %6.2f median", *time.gpu_least_ms, *time.gpu_median_ms);
    std::printf("\n");
  }
}
