// SPDX-License-Identifier: Apache-2.0
#include "core/render/cpu_renderer.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include "core/base/clones.h"
#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "core/light/area_lobes.h"
#include "core/math/functions.h"
#include "core/render/ambient/ambient.h"
#include "core/render/ambient/light_samples.h"
#include "core/render/backdrop.h"
#include "core/render/camera.h"
#include "core/render/display.h"
#include "core/render/mesh/mesh_view.h"
#include "core/render/surface_textures.h"

// The loops over a chunk are compiled for several instruction sets.
#define ETAK_RENDER_CLONES ETAK_CLONES_O3("arch=x86-64-v3", "arch=x86-64-v4")

namespace etak {
namespace {

constexpr std::size_t tile_rows = 8, chunk_size = 256;

// Writes the pixels of rows into a picture of floats.
struct PicturePixels {
  Image& picture;
  std::array<float, 4> empty;

  PicturePixels(const Scene& scene, Image& picture_)
      : picture(picture_),
        empty{float(scene.background[0]), float(scene.background[1]), float(scene.background[2]), 0} {}

  void clear(int first, int last, int row) const {
    float* out =
        picture.values.data() + 4 * (std::size_t(row) * std::size_t(picture.width) + std::size_t(first));
    for (int x = first; x < last; ++x, out += 4) std::copy_n(empty.data(), 4, out);
  }
  template <class Store>
  void put(int first, int row, std::size_t, Store store) const {
    store(picture.at(first, row).data());
  }
};

// Writes the pixels of rows into a picture of codes, by way of a buffer that stays in the first-level cache.
struct PictureCodes {
  Image8& picture;
  double exposure;
  Transfer transfer;
  Tone tone;
  std::array<std::uint8_t, 3> empty;

  PictureCodes(const Scene& scene, Image8& picture_)
      : picture(picture_), exposure(scene.exposure), transfer(scene.transfer), tone(scene.tone) {
    const float background[4] = {float(scene.background[0]), float(scene.background[1]),
                                 float(scene.background[2]), 0};
    to_codes(background, exposure, transfer, tone, empty.data());
  }

  void clear(int first, int last, int row) const {
    std::uint8_t* out =
        picture.values.data() + 3 * (std::size_t(row) * std::size_t(picture.width) + std::size_t(first));
    const auto [red, green, blue] = empty;
    for (int x = first; x < last; ++x, out += 3) {
      out[0] = red;
      out[1] = green;
      out[2] = blue;
    }
  }
  template <class Store>
  void put(int first, int row, std::size_t count, Store store) const {
    alignas(64) float pixels[4 * chunk_size];
    store(pixels);
    to_codes({pixels, 4 * count}, exposure, transfer, tone, picture.at(first, row).data());
  }
};

namespace f32 {
#include "core/math/real_f32.h"

#include "core/render/shade/shade_chunk.h"

void respond(const Model& model, const double* values, const Range& range, Chunk& c) {
  const std::size_t first = range.first;
  const float* const directions[6] = {&c.local_light[0][first],  &c.local_light[1][first],
                                      &c.local_light[2][first],  &c.local_viewer[0][first],
                                      &c.local_viewer[1][first], &c.local_viewer[2][first]};
  float* const rgb[3] = {&c.response[0][first], &c.response[1][first], &c.response[2][first]};
  model.f32_batch(range.last - first, directions, values, rgb);
}

constexpr bool has_far_respond = true;
void respond_far(const Model& model, const double* values, double lh, const Range& range, Chunk& c) {
  const std::size_t first = range.first;
  const float* const turned[5] = {&c.local_light[2][first], &c.local_viewer[2][first],
                                  &c.local_half[0][first], &c.local_half[1][first], &c.local_half[2][first]};
  float* const rgb[3] = {&c.response[0][first], &c.response[1][first], &c.response[2][first]};
  model.f32_batch_far(range.last - first, lh, turned, values, rgb);
}

#include "core/render/shade/shade_picture.h"
}  // namespace f32

namespace f64 {
#include "core/math/real_f64.h"

#include "core/render/shade/shade_chunk.h"

void respond(const Model& model, const double* values, const Range& range, Chunk& c) {
  for (std::size_t i = range.first; i < range.last; ++i) {
    const Directions d{c.local_light[0][i],  c.local_light[1][i],  c.local_light[2][i],
                       c.local_viewer[0][i], c.local_viewer[1][i], c.local_viewer[2][i]};
    double rgb[3];
    model.f64(d, values, rgb);
    for (std::size_t channel = 0; channel < 3; ++channel) c.response[channel][i] = rgb[channel];
  }
}

// The reference evaluates both directions at every point and has no loop for light at infinity.
constexpr bool has_far_respond = false;
void respond_far(const Model&, const double*, double, const Range&, Chunk&) {}

#include "core/render/shade/shade_picture.h"
}  // namespace f64

}  // namespace

void render_cpu(const Scene& scene, const Environment* environment, unsigned threads, Precision precision,
                Image& picture, const RowsDone& rows_done) {
  validate(scene, true);
  if (picture.width != scene.width || picture.height != scene.height || picture.channels != 4)
    picture = Image(scene.width, scene.height, 4);
  const PicturePixels target(scene, picture);
  if (precision == Precision::f32)
    f32::draw(scene, environment, threads, target, rows_done);
  else
    f64::draw(scene, environment, threads, target, rows_done);
}

void render_cpu_codes(const Scene& scene, const Environment* environment, unsigned threads, Image8& picture) {
  validate(scene, true);
  if (picture.width != scene.width || picture.height != scene.height || picture.channels != 3)
    picture = Image8(scene.width, scene.height, 3);
  f32::draw(scene, environment, threads, PictureCodes(scene, picture), {});
}

}  // namespace etak
