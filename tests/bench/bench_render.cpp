// SPDX-License-Identifier: Apache-2.0
// bench_render [ROUNDS [SIZE [MODEL...]]]: milliseconds a frame of the CPU renderer, every model of the
// registry on a sphere of SIZE x SIZE pixels (512) under 4 directional lights, seen orthographically: linear
// radiance in floats, and the same with the picture's 8-bit codes. Gold's colours; one thread and two; all
// models in turn, round after round; least and median. Wall time, so the machine has to be quiet.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "core/brdf/models.h"
#include "core/render/cpu_renderer.h"
#include "core/render/display.h"

namespace {

using namespace etak;

// Spread over the half space of the camera by the golden angle.
std::vector<Light> four_lights() {
  std::vector<Light> lights;
  for (int i = 0; i < 4; ++i) {
    const double turn = i * 2.399963, z = 0.25 + 0.7 * i / 4, r = std::sqrt(1 - z * z);
    Light light;
    light.direction = {-r * std::cos(turn), -r * std::sin(turn), -z};
    light.intensity = 0.6;
    lights.push_back(light);
  }
  return lights;
}

Scene scene_of(const Model& model, int size) {
  Scene scene;
  scene.surface.f0 = {1.0, 0.77, 0.33};
  scene.surface.n = {0.18, 0.42, 1.37};
  scene.surface.k = {3.1, 2.35, 1.77};
  scene.surface.gloss = 0.6;
  (model.kind == ModelKind::diffuse ? scene.diffuse : scene.specular) = &model;
  if (model.kind != ModelKind::specular) scene.surface.diffuse = {0.5, 0.4, 0.3};
  (model.kind == ModelKind::diffuse ? scene.diffuse_values : scene.specular_values) =
      model_values(model, scene.surface, {});
  scene.lights.lights = four_lights();
  scene.width = scene.height = size;
  return scene;
}

struct Row {
  const Model* model;
  Scene scene;
  std::array<std::vector<double>, 4> ms;
};

template <class Work>
double milliseconds(Work work) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 31;
  const int size = argc > 2 ? std::clamp(std::atoi(argv[2]), 1, max_image_side) : 512;
  std::vector<Row> rows;
  for (const Model& model : models()) {
    const bool wanted =
        argc <= 3 || std::any_of(argv + 3, argv + argc, [&](const char* each) { return model.id == each; });
    if (wanted) rows.push_back({&model, scene_of(model, size), {}});
  }
  // One picture for all: a program that draws frame after frame keeps its picture too.
  Image picture;
  Image8 codes;
  std::size_t sum = 0;
  for (int round = 0; round < rounds; ++round)
    for (Row& row : rows) {
      for (unsigned threads = 1; threads <= 2; ++threads) {
        row.ms[threads - 1].push_back(
            milliseconds([&] { render_cpu(row.scene, nullptr, threads, Precision::f32, picture); }));
        row.ms[threads + 1].push_back(
            milliseconds([&] { render_cpu_codes(row.scene, nullptr, threads, codes); }));
      }
      sum += codes.values[codes.values.size() / 2];
    }
  std::printf("%d x %d, 4 lights, %s, %d rounds (%zu)\n", size, size,
              std::string(batch_instruction_set()).c_str(), rounds, sum);
  std::printf("%-30s %19s %19s %19s %19s\n", "ms a frame: least, median", "floats, 1 thread", "2 threads",
              "codes, 1 thread", "2 threads");
  for (const Row& row : rows) {
    std::printf("%-30s", std::string(row.model->id).c_str());
    for (const std::vector<double>& ms : row.ms)
      std::printf("   %8.3f %8.3f", *std::min_element(ms.begin(), ms.end()), median(ms));
    std::printf("\n");
  }
}
