// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/prefilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/clones.h"
#include "core/base/parallel.h"
#include "core/color/gloss.h"
#include "core/math/functions.h"
#include "core/render/ambient/lat_long.h"
#include "core/render/ambient/round_lobe.h"

namespace etak {
namespace {

#include "core/render/ambient/ambient_text.h"

using std::numbers::pi;

// Adds `from`, times a weight. Without fused operations, so that all instruction sets give the same sums.
ETAK_CLONES_O3("avx2")
void add_weighted(double* to, const float* from, double weight, int count) {
  for (int i = 0; i < count; ++i) to[i] += weight * double{from[i]};
}

// The rows of a map, so that a sum over neighbouring columns can be made for many places at once. Of the columns
// every `stride`-th lies in one run, and each run stands three times, because columns wrap around.
class Runs {
 public:
  Runs(const Image& map, int stride) : count_(map.width / stride), stride_(stride), rows_(map.height) {
    values_.reserve(map.values.size() * 3);
    for (std::size_t channel = 0; channel < 3; ++channel)
      for (int y = 0; y < map.height; ++y)
        for (int first = 0; first < stride; ++first)
          for (int i = 0; i < 3 * count_; ++i)
            values_.push_back(map.at(first + i % count_ * stride, y)[channel]);
  }
  // The columns column, column + stride, ... of a row, as many as a run has.
  const float* from(std::size_t channel, int y, int column) const {
    const int before = column < 0 ? (column + 1) / stride_ - 1 : column / stride_;
    const int run = (static_cast<int>(channel) * rows_ + y) * stride_ + column - before * stride_;
    return values_.data() + static_cast<std::ptrdiff_t>(run) * 3 * count_ + count_ + before;
  }

 private:
  int count_, stride_, rows_;
  std::vector<float> values_;
};

// A map of width x width/2 pixels: for each of its directions r the sums S of weight(c) radiance d_omega and T of
// weight(c) d_omega, over the pixels of `seen` whose cosine c with r is above `least`, as finish(r, S, T).
//
// The cosine depends on both rows and on the difference of the columns alone. So a weight is computed once for
// all pixels of a row of the result that lie alike between the columns of `seen`, and not once for each of them.
template <class Weight, class Finish>
Image summed(const Image& seen, int width, double least, unsigned threads, Weight weight, Finish finish) {
  Image out(width, width / 2, 3);
  // Pixels i * phases + p of a row lie alike for all i below `alike`.
  const int alike = std::gcd(width, seen.width), phases = width / alike, stride = seen.width / alike;
  const Runs runs(seen, stride);
  const double reach = math::acos(std::clamp(least, -1.0, 1.0));
  const auto row_of = [&](int row) {
    const double v = (row + 0.5) / out.height;
    const MapRow angles(v);
    std::array<std::vector<double>, 3> sums;
    for (auto& each : sums) each.resize(static_cast<std::size_t>(width));
    std::vector<double> totals(static_cast<std::size_t>(phases));
    const double middle = v * seen.height, rows = reach / pi * seen.height;
    const int first_row = std::max(0, static_cast<int>(std::floor(middle - rows)) - 1);
    const int last_row = std::min(seen.height, static_cast<int>(std::ceil(middle + rows)) + 1);
    for (int y = first_row; y < last_row; ++y) {
      const double theta = pi * (y + 0.5) / seen.height, omega = solid_angle(seen, y);
      const double across = angles.sine * math::sin(theta), along = angles.cosine * math::cos(theta);
      // Columns whose cosine may be above `least`: those with cos(difference) above (least - along) / across.
      if (across + along <= least) continue;
      const double side = math::acos(std::clamp((least - along) / std::max(across, 1e-300), -1.0, 1.0));
      const int half = std::min(seen.width / 2, static_cast<int>(side / (2 * pi) * seen.width) + 2);
      const int columns = std::min(seen.width, 2 * half + 1);
      for (int p = 0; p < phases; ++p) {
        const double place = (p + 0.5) * seen.width / width;
        const int nearest = static_cast<int>(std::floor(place));
        for (int k = nearest - half; k < nearest - half + columns; ++k) {
          const double c = across * math::cos(2 * pi * (k + 0.5 - place) / seen.width) + along;
          if (c <= least) continue;
          const double w = weight(c) * omega;
          totals[static_cast<std::size_t>(p)] += w;
          for (std::size_t channel = 0; channel < 3; ++channel)
            add_weighted(sums[channel].data() + p * alike, runs.from(channel, y, k), w, alike);
        }
      }
    }
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(x % phases * alike + x / phases);
      const Vec3 sum{sums[0][at], sums[1][at], sums[2][at]};
      const Vec3 value =
          finish(direction_at((x + 0.5) / width, angles), sum, totals[static_cast<std::size_t>(x % phases)]);
      for (std::size_t i = 0; i < 3; ++i) out.at(x, row)[i] = static_cast<float>(value[i]);
    }
  };
  parallel_chunks(static_cast<std::size_t>(out.height), threads, 1,
                  [&](std::size_t row, std::size_t, unsigned) { row_of(static_cast<int>(row)); });
  return out;
}

// round_lobe() as a table over the cosines that matter, linear between 2048 steps.
class LobeWeight {
 public:
  explicit LobeWeight(double e) : least_(std::max(0.0, 2 * math::exp2(math::log2(1e-4) * 2 / e) - 1)) {
    for (int i = 0; i <= steps; ++i) {
      const double c = least_ + (1 - least_) * i / steps;
      values_.push_back(round_lobe(e, c));
    }
    values_.push_back(values_.back());
  }
  double least() const { return least_; }  // the lobe is below 1e-4 of its peak beneath this cosine
  double at(double c) const {
    const double at = std::min((c - least_) / (1 - least_), 1.0) * steps;
    const auto i = static_cast<std::size_t>(at);
    return values_[i] + (values_[i + 1] - values_[i]) * (at - static_cast<double>(i));
  }

 private:
  static constexpr int steps = 2048;
  double least_;
  std::vector<double> values_;
};

}  // namespace

Image lobe_map(const Image& map, double gloss, double widest, unsigned threads, int most) {
  const double e = exponent_of_gloss(gloss);
  // A pixel of the result spans half the width of the lobe, and a pixel of the summed map spans about a quarter:
  // so that it has once or twice as many columns as the result, which summed() is quick with.
  const double wanted = std::clamp(6.3 * std::sqrt(e), 32.0, widest);
  const int width = 1 << static_cast<int>(std::ceil(math::log2(wanted)));
  const int times = static_cast<int>(std::ceil(2 * wanted / width - 0.25));
  const Image seen = at_most(map, std::min(times * width, most));
  const LobeWeight weight(e);
  return summed(
      seen, width, weight.least(), threads, [&](double c) { return weight.at(c); },
      [&](const Vec3& r, const Vec3& sum, double total) {
        // Between the pixels of a map that is coarser than the lobe there may be none within it.
        if (total == 0) return look_up(seen, place_of(r));
        return Vec3{sum[0] / total, sum[1] / total, sum[2] / total};
      });
}

Image stacked(const std::vector<const Image*>& levels, int tile, unsigned threads) {
  const int inner = tile - 2;
  Image out(tile, tile * static_cast<int>(levels.size()), 4);
  parallel_chunks(
      static_cast<std::size_t>(out.height), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
          const Image& map = *levels[static_cast<std::size_t>(row / tile)];
          for (int x = 0; x < tile; ++x) {
            const auto d = ambient_text::octahedral_direction((x - 0.5) / inner, (row % tile - 0.5) / inner);
            const Vec3 v = look_up(map, place_of({d.x, d.y, d.z}));
            for (std::size_t c = 0; c < 3; ++c) out.at(x, row)[c] = static_cast<float>(v[c]);
          }
        }
      });
  return out;
}

Image irradiance_of(const Image& map, unsigned threads) {
  return summed(
      at_most(map, 128), 64, 0, threads, [](double c) { return c; },
      [](const Vec3&, const Vec3& sum, double) { return sum; });
}

Image at_most(const Image& map, int width) {
  return map.width <= width ? map : shrunk(map, width, std::min(map.height, width / 2));
}

Vec3 in_stack(const Image& stack, int tile, const Vec3& r, double level) {
  const int count = stack.height / tile;
  const auto first = std::min(static_cast<int>(std::max(level, 0.0)), count - 2);
  const double share = std::clamp(level - first, 0.0, 1.0);
  const ambient_text::vec3 place = ambient_text::octahedral_place({r[0], r[1], r[2]});
  // Looks up two levels at once, as look_up() does one.
  const double x = place.x * (tile - 2) + 0.5, y = place.y * (tile - 2) + 0.5;
  const int x0 = std::clamp(static_cast<int>(x), 0, tile - 2),
            y0 = std::clamp(static_cast<int>(y), 0, tile - 2);
  const double fx = x - x0, fy = y - y0;
  Vec3 out{};
  for (int i = 0; i < 2; ++i) {
    const double weight = i == 0 ? 1 - share : share;
    const int top = (first + i) * tile + y0;
    const auto a = stack.at(x0, top), b = stack.at(x0 + 1, top), c = stack.at(x0, top + 1),
               d = stack.at(x0 + 1, top + 1);
    for (std::size_t k = 0; k < 3; ++k)
      out[k] += weight * ((double{a[k]} * (1 - fx) + double{b[k]} * fx) * (1 - fy) +
                          (double{c[k]} * (1 - fx) + double{d[k]} * fx) * fy);
  }
  return out;
}

}  // namespace etak
