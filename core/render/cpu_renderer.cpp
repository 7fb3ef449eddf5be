// SPDX-License-Identifier: Apache-2.0
#include "core/render/cpu_renderer.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/base/parallel.h"
#include "core/render/camera.h"

// The loops over a chunk exist once per instruction set, the processor's best is taken at start-up.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ETAK_RENDER_CLONES \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), optimize("O3")))
#else
#define ETAK_RENDER_CLONES
#endif

namespace etak {
namespace {

constexpr std::size_t tile_rows = 8;

namespace f32 {
using real = float;
constexpr real tiny = 1e-37f, power_floor = -90, exponent_floor = -62, largest_reflectance = 1 - 1e-6f;
#include "core/render/shade_chunk.h"

void respond(const Model& model, const double* values, std::size_t first, std::size_t last, Chunk& c) {
  const float* const directions[6] = {&c.local_light[0][first],  &c.local_light[1][first],
                                      &c.local_light[2][first],  &c.local_viewer[0][first],
                                      &c.local_viewer[1][first], &c.local_viewer[2][first]};
  float* const rgb[3] = {&c.response[0][first], &c.response[1][first], &c.response[2][first]};
  model.f32_batch(last - first, directions, values, rgb);
}

#include "core/render/shade_picture.h"
}  // namespace f32

namespace f64 {
using real = double;
constexpr real tiny = 1e-300, power_floor = -1e300, exponent_floor = -1e300, largest_reflectance = 1 - 1e-12;
#include "core/render/shade_chunk.h"

void respond(const Model& model, const double* values, std::size_t first, std::size_t last, Chunk& c) {
  for (std::size_t i = first; i < last; ++i) {
    const Directions d{c.local_light[0][i],  c.local_light[1][i],  c.local_light[2][i],
                       c.local_viewer[0][i], c.local_viewer[1][i], c.local_viewer[2][i]};
    double rgb[3];
    model.f64(d, values, rgb);
    for (std::size_t channel = 0; channel < 3; ++channel) c.response[channel][i] = rgb[channel];
  }
}

#include "core/render/shade_picture.h"
}  // namespace f64

}  // namespace

void render_cpu(const Scene& scene, const Environment* environment, unsigned threads, Precision precision,
                Image& picture, const RowsDone& rows_done) {
  validate(scene);
  if (picture.width != scene.width || picture.height != scene.height || picture.channels != 4)
    picture = Image(scene.width, scene.height, 4);
  if (precision == Precision::f32)
    f32::draw(scene, environment, threads, picture, rows_done);
  else
    f64::draw(scene, environment, threads, picture, rows_done);
}

}  // namespace etak
