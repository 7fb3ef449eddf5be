// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parts of the mip chain that codes and floats share; for mips*.cpp and mip_rows*.cpp only.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "core/image/mips.h"

namespace etak::mip_detail {

/// One texel as four numbers on scales that may be averaged:
///   texture A   linear R, G, B, opacity (in the unit of the source: codes or fractions)
///   texture B   linear R, G, B, 1/e
///   normals     unit normal x, y, z, 0; or slopes p, q, p^2 + q^2, 0
using Float4 = float __attribute__((vector_size(16)));
struct Texel {
  Float4 v;
};

/// The old texels that a new texel covers along one axis, and the share of each: one texel (where the side is
/// 1 and stays 1), two (even sides), or three (odd sides, 2k + 1 to k: each new texel is 2 + 1/k wide).
struct Taps {
  int first = 0, count = 0;
  std::array<float, 3> share{};
};
inline Taps taps_of(int old_side, int new_side, int index) {
  if (old_side == new_side) return {index, 1, {1, 0, 0}};
  if (old_side == 2 * new_side) return {2 * index, 2, {0.5f, 0.5f, 0}};
  const auto k = static_cast<float>(new_side), i = static_cast<float>(index), all = 2 * k + 1;
  return {2 * index, 3, {(k - i) / all, k / all, (i + 1) / all}};
}

inline Float4 fourth_everywhere(Float4 v) {
  return __builtin_shufflevector(v, v, 3, 3, 3, 3);
}

/// The mean of texels of texture A, their colours weighted by opacity.
///   plain      mean of the texels
///   weighted   mean of the texels times their fourth lane
inline Float4 mean_of_a(Float4 plain, Float4 weighted) {
  const float opacity = plain[3];
  if (!(opacity > 0)) return plain;  // all are transparent: every texel has the same weight
  Float4 out = weighted * (1 / opacity);
  out[3] = opacity;
  return out;
}

/// The mean of texels of texture B, with 1/e weighted by the luminance Y of F0. Y is linear in F0, so the
/// mean of Y(F0) / e is Y of the mean of F0 / e.
///   plain, weighted   as in mean_of_a()
inline Float4 mean_of_b(Float4 plain, Float4 weighted) {
  const auto y = [](Float4 c) { return luminance_of<float>(c[0], c[1], c[2]); };
  const float all = y(plain), part = y(weighted);
  if (all > 0 && part > 0) plain[3] = part / all;
  return plain;
}

/// A row of texels that is in memory. Rows of every Source have the same three functions, which give the
/// texel in column x of texture A, of texture B and of the normals.
struct StoredRow {
  const Texel *texels_a, *texels_b, *texels_n;
  Float4 a(int x) const { return texels_a[x].v; }
  Float4 b(int x) const { return texels_b[x].v; }
  Float4 n(int x) const { return texels_n[x].v; }
};
/// Where a new row is written.
struct OutRow {
  Texel *a, *b, *n;  // n is null where there are no normals
};

/// Makes the first texels of a new row whose texels cover 2 x 2 old ones, for sources that have a faster way
/// than the plain loop of average_rows(); such a source overloads this function for its Row. Returns how many
/// texels of textures A and B were made.
template <class Row>
int average_first(const std::array<Row, 3>&, int, bool, const OutRow&) {
  return 0;
}

/// Makes a new row from the old rows that it covers.
///   rows     the old rows; the first across.count are used
///   across   the shares of the old rows
template <class Row>
void average_rows(const std::array<Row, 3>& rows, const Taps& across, int old_width, int new_width,
                  bool weigh_by_opacity, const OutRow& out) {
  const auto put = [&](int x, Float4 a, Float4 weighted_a, Float4 b, Float4 weighted_b) {
    out.a[x].v = weigh_by_opacity ? mean_of_a(a, weighted_a) : a;
    out.b[x].v = mean_of_b(b, weighted_b);
  };
  if (across.count == 2 && old_width == 2 * new_width) {  // both sides even: nearly all pictures
    for (int x = average_first(rows, new_width, weigh_by_opacity, out); x < new_width; ++x) {
      const Float4 a0 = rows[0].a(2 * x), a1 = rows[0].a(2 * x + 1);
      const Float4 a2 = rows[1].a(2 * x), a3 = rows[1].a(2 * x + 1);
      const Float4 b0 = rows[0].b(2 * x), b1 = rows[0].b(2 * x + 1);
      const Float4 b2 = rows[1].b(2 * x), b3 = rows[1].b(2 * x + 1);
      const auto weighted = [](Float4 c) { return c * fourth_everywhere(c); };
      put(x, 0.25f * ((a0 + a1) + (a2 + a3)),
          0.25f * ((weighted(a0) + weighted(a1)) + (weighted(a2) + weighted(a3))),
          0.25f * ((b0 + b1) + (b2 + b3)),
          0.25f * ((weighted(b0) + weighted(b1)) + (weighted(b2) + weighted(b3))));
    }
  } else {
    for (int x = 0; x < new_width; ++x) {
      const Taps along = taps_of(old_width, new_width, x);
      Float4 a{}, weighted_a{}, b{}, weighted_b{};
      for (int j = 0; j < across.count; ++j)
        for (int i = 0; i < along.count; ++i) {
          const float share =
              across.share[static_cast<std::size_t>(j)] * along.share[static_cast<std::size_t>(i)];
          const Row& row = rows[static_cast<std::size_t>(j)];
          const Float4 one_a = row.a(along.first + i), one_b = row.b(along.first + i);
          a += share * one_a;
          weighted_a += share * (one_a * fourth_everywhere(one_a));
          b += share * one_b;
          weighted_b += share * (one_b * fourth_everywhere(one_b));
        }
      put(x, a, weighted_a, b, weighted_b);
    }
  }
  if (out.n == nullptr) return;
  for (int x = 0; x < new_width; ++x) {
    const Taps along = taps_of(old_width, new_width, x);
    Float4 n{};
    for (int j = 0; j < across.count; ++j)
      for (int i = 0; i < along.count; ++i)
        n += across.share[static_cast<std::size_t>(j)] * along.share[static_cast<std::size_t>(i)] *
             rows[static_cast<std::size_t>(j)].n(along.first + i);
    out.n[x].v = n;
  }
}

/// The side at a level, in texels, of a picture whose level 0 has `side`.
inline int side_at(int side, int level) {
  return std::max(1, side >> level);
}

/// A whole level of texels in memory, from which the smaller levels are made.
struct StoredPicture {
  int width = 0;
  std::vector<Texel> a, b, n;

  StoredPicture(int width_, int height, bool normals) : width(width_) {
    const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height);
    a.resize(count);
    b.resize(count);
    if (normals) n.resize(count);
  }
  OutRow out(int y) {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    return {a.data() + at, b.data() + at, n.empty() ? nullptr : n.data() + at};
  }
  StoredRow row(int y) const {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    return {a.data() + at, b.data() + at, n.empty() ? nullptr : n.data() + at};
  }
};

/// The settings that hold for the whole chain.
struct ChainShape {
  int width = 0, height = 0, levels = 0;  // sides of level 0, and how many levels there are with it
  bool weigh_by_opacity = true, normals = false;
};

/// Makes the rows of levels base + 1 .. top. Each row is made when it is needed, from at most three rows of
/// the next finer level, and each level keeps its last four rows, so that the whole cascade fits into the
/// cache.
template <class Source, class Sink>
class Cascade {
 public:
  /// sink(level, y, row) is called once for each row that a call of make() hands out (see there).
  Cascade(const ChainShape& shape, int base, int top, const Source& source, const Sink& sink)
      : shape_(shape), base_(base), source_(source), sink_(sink) {
    for (int level = base + 1; level <= top; ++level)
      rings_.emplace_back().texels.resize(static_cast<std::size_t>(side_at(shape.width, level)) * 4 * 3);
  }

  /// Makes rows [first, last) of level `top`, and the rows of the finer levels that these are made from.
  /// Hands all of them to the sink, except for rows of finer levels that the next band hands out.
  void make(int first, int last) {
    const auto top = base_ + static_cast<int>(rings_.size());
    int begin = first, end = last;
    for (int level = top; level > base_; --level) {
      Ring& ring = rings_[static_cast<std::size_t>(level - base_ - 1)];
      ring.begin = begin;
      ring.end = end;
      const int height = side_at(shape_.height, level), above = side_at(shape_.height, level - 1);
      begin = taps_of(above, height, begin).first;
      end = end == height ? above : taps_of(above, height, end).first;
    }
    // A row in a ring can be one that was not handed out because it belonged to another band.
    for (Ring& ring : rings_) ring.held.fill(-1);
    for (int y = first; y < last; ++y) row(top, y);
  }

 private:
  struct Ring {
    std::vector<Texel> texels;  // four rows each of texture A, of texture B and of normals
    std::array<int, 4> held{};  // index of the row that each slot holds; -1: none
    int begin = 0, end = 0;     // rows of the level that this band hands out
  };

  StoredRow row(int level, int y) {
    Ring& ring = rings_[static_cast<std::size_t>(level - base_ - 1)];
    const auto slot = static_cast<std::size_t>(y) % 4;
    const auto width = static_cast<std::size_t>(side_at(shape_.width, level));
    Texel* const a = ring.texels.data() + slot * 3 * width;
    const OutRow out{a, a + width, shape_.normals ? a + 2 * width : nullptr};
    const StoredRow stored{out.a, out.b, out.n};
    if (ring.held[slot] == y) return stored;
    const int old_width = side_at(shape_.width, level - 1);
    const Taps taps = taps_of(side_at(shape_.height, level - 1), side_at(shape_.height, level), y);
    const auto average = [&](auto&& get) {
      const auto first = get(taps.first);
      std::array rows{first, first, first};
      for (int j = 1; j < taps.count; ++j) rows[static_cast<std::size_t>(j)] = get(taps.first + j);
      average_rows(rows, taps, old_width, static_cast<int>(width), shape_.weigh_by_opacity, out);
    };
    if (level - 1 == base_)
      average([&](int above) { return source_.row(above); });
    else
      average([&](int above) { return row(level - 1, above); });
    ring.held[slot] = y;
    if (y >= ring.begin && y < ring.end) sink_(level, y, stored);
    return stored;
  }

  const ChainShape& shape_;
  int base_;
  const Source& source_;
  const Sink& sink_;
  std::vector<Ring> rings_;
};

/// Makes all levels but level 0. Levels 1 to 5 go through a Cascade in bands of rows, on `threads` threads;
/// the smaller levels are made from level 5, which is kept whole. Every texel is computed by the same
/// operations whatever the bands, so the result does not depend on the number of threads.
///   sink(level, y, row)   is called once for each row; by several threads at once
template <class Source, class Sink>
void make_chain(const ChainShape& shape, unsigned threads, const Source& source, const Sink& sink) {
  const int last = shape.levels - 1;
  if (last < 1) return;
  const int top = std::min(last, 5);
  const int top_width = side_at(shape.width, top), top_height = side_at(shape.height, top);
  StoredPicture kept(top_width, last > top ? top_height : 0, shape.normals);
  const auto keep_too = [&](int level, int y, const StoredRow& row) {
    sink(level, y, row);
    if (level != top || last == top) return;
    const OutRow to = kept.out(y);
    std::copy_n(row.texels_a, top_width, to.a);
    std::copy_n(row.texels_b, top_width, to.b);
    if (to.n != nullptr) std::copy_n(row.texels_n, top_width, to.n);
  };
  using Bands = Cascade<Source, decltype(keep_too)>;
  const auto rows = static_cast<std::size_t>(top_height);
  const std::size_t chunk = std::max<std::size_t>(1, rows / (std::size_t{4} * std::max(1u, threads)));
  std::vector<std::unique_ptr<Bands>> workers(std::max(1u, threads));
  parallel_chunks(rows, threads, chunk, [&](std::size_t begin, std::size_t end, unsigned worker) {
    auto& bands = workers[worker];
    if (!bands) bands = std::make_unique<Bands>(shape, 0, top, source, keep_too);
    bands->make(static_cast<int>(begin), static_cast<int>(end));
  });
  if (last == top) return;
  Cascade<StoredPicture, Sink> rest(shape, top, last, kept, sink);
  rest.make(0, side_at(shape.height, last));
}

/// What the spread of the normals that a texel covers adds to 1/e; may be infinite.
///   n         the mean of normal_lanes()
///   toksvig   (1 - |N|) / |N|, N the mean of the unit normals
///   slopes    half the sum of the variances of the two slopes
inline float added_variance(Float4 n, NormalVariance kind) {
  if (kind == NormalVariance::slopes) return std::max(0.0f, (n[2] - n[0] * n[0] - n[1] * n[1]) / 2);
  const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return std::max(0.0f, (1 - length) / length);
}

/// A decoded normal as the numbers that the chain averages. The slopes of normals steeper than 89.1 degrees
/// would outweigh all others, so z is taken as at least 1/64.
inline Float4 normal_lanes(float x, float y, float z, NormalVariance kind) {
  const float length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return kind == NormalVariance::slopes ? Float4{} : Float4{0, 0, 1, 0};
  x /= length;
  y /= length;
  z /= length;
  if (kind == NormalVariance::toksvig) return Float4{x, y, z, 0};
  const float p = x / std::max(z, 1.0f / 64), q = y / std::max(z, 1.0f / 64);
  return Float4{p, q, p * p + q * q, 0};
}

/// Writes the opacities of row y to `out`, rounded as they would be stored.
using OpacityRow = std::function<void(int y, float* out)>;

/// Share of the surface whose opacity is at least `cutoff`, [0, 1], from 4 x 4 samples of the bilinear patch
/// between each four neighbouring texel centres.
double coverage(int width, int height, float cutoff, unsigned threads, const OpacityRow& row);

/// The opacities of a level, width x height of them, not scaled yet.
///   largest   they are 0..largest
///   rounded   true: they are stored as whole numbers
struct OpacityLevel {
  std::span<const float> opacities;
  int width, height;
  float largest;
  bool rounded;
};

/// The factor for the opacities of a level that brings its coverage nearest to `share`.
///   returns   2^(k/256), k a whole number; 1 where no other factor comes nearer
float coverage_factor(const OpacityLevel& level, float cutoff, double share, unsigned threads);

/// An opacity times the factor of its level, as it is stored.
inline float scaled_opacity(float opacity, float factor, float largest, bool rounded) {
  const float scaled = std::min(largest, opacity * factor);
  return rounded ? static_cast<float>(static_cast<int>(scaled + 0.5f)) : scaled;  // never negative
}

}  // namespace etak::mip_detail
