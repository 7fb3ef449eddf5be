// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/lobe_samples.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/color/delta_e.h"
#include "core/render/cpu_renderer.h"
#include "core/render/lobe_density.h"
#include "core/render/reference.h"
#include "tests/support.h"

namespace etak {
namespace {

Scene ball(const char* specular, const char* diffuse, double gloss, int size = 24) {
  Scene scene;
  scene.width = scene.height = size;
  scene.background = {0, 0, 0};
  scene.surface.f0 = {0.95, 0.64, 0.54};
  scene.surface.diffuse = {0.2, 0.4, 0.6};
  scene.surface.gloss = gloss;
  complete_from_f0(scene.surface);
  scene.specular = *specular != 0 ? find_model(specular) : nullptr;
  scene.diffuse = *diffuse != 0 ? find_model(diffuse) : nullptr;
  if (scene.specular) scene.specular_values = model_values(*scene.specular, scene.surface, {});
  if (scene.diffuse) scene.diffuse_values = model_values(*scene.diffuse, scene.surface, {});
  scene.refined = true;
  return scene;
}

Image drawn(const Scene& scene, const Environment* environment, unsigned threads = 2,
            Precision precision = Precision::f32) {
  Image out;
  render_cpu(scene, environment, threads, precision, out);
  return out;
}

// CIEDE2000 over the pixels that the ball covers whole.
struct Differences {
  double mean = 0, worst = 0;
};
Differences differences(const Image& a, const Image& b) {
  Differences out;
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (a.at(x, y)[3] < 1 || b.at(x, y)[3] < 1) continue;
      const auto lab = [&](const Image& of) {
        Vec3 rgb{};
        for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(double{of.at(x, y)[c]}, 0.0, 1.0);
        return to_lab(to_rgb(rgb));
      };
      const double off = delta_e2000(lab(a), lab(b));
      out.worst = std::max(out.worst, off);
      out.mean += off;
      ++count;
    }
  out.mean /= count;
  return out;
}

}  // namespace

TEST_CASE("a density of half vectors sums up to one and is inverted") {
  for (const char* id : {"ggx-schlick", "phong", "beckmann-smith", "schueler-full", "abc-schlick"}) {
    const Scene scene = ball(id, "", 0.6);
    const LobeDensity density(*scene.specular, scene.specular_values);
    double sum = 0, share = 0;
    for (int i = 0; i < 200000; ++i) {
      const double polar = std::numbers::pi / 2 * (i + 0.5) / 200000;
      const double here =
          density.pdf(polar) * 2 * std::numbers::pi * std::sin(polar) * std::numbers::pi / 400000;
      if (polar < density.polar(0.3)) share += here;
      sum += here;
    }
    CAPTURE(id);
    CHECK(sum == Approx(1).epsilon(2e-3));
    CHECK(share == Approx(0.3).epsilon(2e-2));
  }
}

TEST_CASE("hemispheres follow the chosen model in a refined picture") {
  for (const char* id : {"ggx-schlick", "schueler-optimized-bounded", "blinn-phong"}) {
    Scene scene = ball(id, "", 0.4);
    scene.lights.hemispheres = Hemispheres{};
    scene.lights.hemispheres->upper = {0.9, 0.9, 0.9};
    scene.lights.hemispheres->lower = {0.2, 0.2, 0.2};
    CAPTURE(id);
    const Differences off =
        differences(drawn(scene, nullptr), render_reference(scene, nullptr, {1, 512, 2}).picture);
    CHECK(off.mean < 0.5);
    CHECK(off.worst < 3);
  }
}

TEST_CASE(
    "a refined picture is closer to the reference than that of a moving one, for lobes with a tangent too") {
  Image map(128, 64, 3, 0.05f);
  for (int x = 20; x < 40; ++x)
    for (int y = 10; y < 34; ++y)
      for (std::size_t c = 0; c < 3; ++c) map.at(x, y)[c] = 4;
  const Environment lamp(map, 1, "lamp", 2);
  for (const char* id : {"ggx-schlick", "ashikhmin-shirley", "blinn-phong"})
    for (const double gloss : {0.3, 0.8}) {
      Scene scene = ball(id, "", gloss);
      const Image truth = render_reference(scene, &lamp, {1, 2048, 2}).picture;
      const double refined = differences(drawn(scene, &lamp), truth).mean;
      scene.refined = false;
      CAPTURE(id, gloss, refined);
      CHECK(refined < differences(drawn(scene, &lamp), truth).mean);
      // The body of Ashikhmin-Shirley changes with the direction of light, and is seen by its irradiance.
      CHECK(refined < (scene.specular->kind == ModelKind::combined ? 1.2 : 0.6));
    }
}

TEST_CASE("a refined picture is the same for any number of threads, and in single as in double precision") {
  Image map(64, 32, 3, 0.1f);
  for (std::size_t c = 0; c < 3; ++c) map.at(4, 10)[c] = 50;
  const Environment sun(map, 1, "sun", 1);
  for (const char* diffuse : {"lambert", "oren-nayar"}) {
    const Scene scene = ball("ggx-schlick", diffuse, 0.4);
    const Image one = drawn(scene, &sun, 1);
    CHECK(drawn(scene, &sun, 3) == one);
    CHECK(differences(one, drawn(scene, &sun, 2, Precision::f64)).worst < 0.1);
  }
}

TEST_CASE("refined light that is black, or one texel of 1e30, is drawn without NaN") {
  Image map(64, 32, 3, 0.0f);
  const Environment black(map, 1, "black", 1);
  const Scene scene = ball("ggx-schlick", "oren-nayar", 0.3);
  for (const float value : drawn(scene, &black).values) REQUIRE((value >= 0 && value <= 1));
  for (std::size_t c = 0; c < 3; ++c) map.at(4, 10)[c] = 1e30f;
  const Environment sun(map, 1, "sun", 1);
  const Image bright = drawn(scene, &sun);
  for (const float value : bright.values) REQUIRE((std::isfinite(value) && value >= 0));
  CHECK(bright.at(12, 12)[1] > 1e20f);
}

}  // namespace etak
