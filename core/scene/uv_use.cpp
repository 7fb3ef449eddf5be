// SPDX-License-Identifier: Apache-2.0
#include "core/scene/uv_use.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/image/wrap.h"

namespace etak {
namespace {

constexpr double most_uv = 1e6;
// Samplers place coordinates to 1/256 of a texel: a triangle that ends that close to a footprint touches it.
constexpr double slack_texels = 1.0 / 256;

using Point = std::array<double, 2>;  // in texels
using Triangle = std::array<Point, 3>;

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// floor() of a number that fits an int; std::floor is a library call where the compiler may not use SSE 4.1.
int floor_of(double v) {
  const int i = static_cast<int>(v);
  return i - (v < i ? 1 : 0);
}

/// Texel i is read at p when |p - (i + 1/2)| < 1, so a range of p reads these.
int first_texel(double least) {
  return floor_of(least - 0.5 - slack_texels);
}
int last_texel(double most) {
  return -floor_of(-(most + 0.5 + slack_texels)) - 1;
}

/// A coordinate of a triangle over at most four periods that begins at `least`, brought near the texture:
/// shifted by a multiple of two periods, which changes nothing under wrapping. Where the sampler clamps, it
/// is cut to as far away as such a triangle can reach that still meets the texture.
double brought_near(double value, double least, double size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(value, -5 * size, 6 * size);
  return value - std::floor(least / (2 * size)) * 2 * size;
}

/// Marks what triangles touch in one texture.
class Raster {
 public:
  Raster(TexelUse& use, Wrap wrap_u, Wrap wrap_v) : use_(use), wrap_u_(wrap_u), wrap_v_(wrap_v) {}

  void everything() {
    std::fill(use_.mask.begin(), use_.mask.end(), std::uint8_t{1});
    full_ = true;
  }

  /// `inside`: the triangle lies in the texture but for half a texel, so what its footprint reaches across a
  /// border is left out.
  void triangle(const Triangle& corner, bool inside) {
    if (full_) return;
    Range x, y;
    for (const Point& p : corner) {
      x.add(p[0]);
      y.add(p[1]);
    }
    if (inside)
      return rows(corner, std::max(0, first_texel(y.least)), std::min(use_.height - 1, last_texel(y.most)),
                  true);
    if (y.most - y.least > 4.0 * use_.height || x.most - x.least > 4.0 * use_.width) return everything();
    // Bring the triangle near the texture, so that texels are counted in ints.
    Triangle near = corner;
    Range y_near;
    for (Point& p : near) {
      p = {brought_near(p[0], x.least, use_.width, wrap_u_),
           brought_near(p[1], y.least, use_.height, wrap_v_)};
      y_near.add(p[1]);
    }
    rows(near, first_texel(y_near.least), last_texel(y_near.most), false);
  }

 private:
  void rows(const Triangle& corner, int first, int last, bool inside) {
    if (first > last) return;
    const auto count = static_cast<std::size_t>(last - first + 1);
    least_.assign(count, std::numeric_limits<double>::infinity());
    most_.assign(count, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < 3; ++i) edge(corner[i], corner[(i + 1) % 3], first, last);
    for (int row = first; row <= last; ++row) {
      const auto at = static_cast<std::size_t>(row - first);
      if (least_[at] > most_[at]) continue;
      int left = first_texel(least_[at]), right = last_texel(most_[at]);
      const int in_row = inside ? row : wrapped_texel(row, use_.height, wrap_v_);
      std::uint8_t* texels =
          use_.mask.data() + static_cast<std::size_t>(in_row) * static_cast<std::size_t>(use_.width);
      if (inside) {
        left = std::max(left, 0);
        right = std::min(right, use_.width - 1);
        if (left <= right) std::memset(texels + left, 1, static_cast<std::size_t>(right - left + 1));
      } else if (right - left + 1 >= use_.width && wrap_u_ == Wrap::repeat) {
        std::memset(texels, 1, static_cast<std::size_t>(use_.width));
      } else {
        for (int i = left; i <= right; ++i) texels[wrapped_texel(i, use_.width, wrap_u_)] = 1;
      }
    }
  }

  /// Widens the range of every row whose footprint band (row - 1/2, row + 3/2) the edge a-b passes by the
  /// part of the edge inside the band. A triangle within a band is widest at corners or where its edges leave
  /// the band.
  void edge(Point a, Point b, int first, int last) {
    if (a[1] > b[1]) std::swap(a, b);
    const int from = std::max(first, first_texel(a[1])), to = std::min(last, last_texel(b[1]));
    const double low = std::min(a[0], b[0]), high = std::max(a[0], b[0]);
    // A level edge has an infinite slope (or none at all: NaN), and min and max then give its ends.
    const double slope = (b[0] - a[0]) / (b[1] - a[1]);
    const double to_top = -0.5 - slack_texels - a[1], to_bottom = 1.5 + slack_texels - a[1];
    const double to_least = slope < 0 ? to_bottom : to_top, to_most = slope < 0 ? to_top : to_bottom;
    for (int row = from; row <= to; ++row) {
      const auto at = static_cast<std::size_t>(row - first);
      least_[at] = std::min(least_[at], std::max(low, a[0] + (row + to_least) * slope));
      most_[at] = std::max(most_[at], std::min(high, a[0] + (row + to_most) * slope));
    }
  }

  TexelUse& use_;
  Wrap wrap_u_, wrap_v_;
  bool full_ = false;
  std::vector<double> least_, most_;  // per row of the triangle at hand
};

/// What a sampler does to one coordinate of a triangle that lies in period `period`: scale * uv + offset is
/// in [0,1].
struct PeriodFold {
  double scale = 1, offset = 0;
};

PeriodFold fold_of_period(Wrap wrap, double period) {
  if (wrap == Wrap::clamp) return {};
  // Every second period of a mirrored texture runs backwards.
  if (wrap == Wrap::mirrored && std::fmod(period, 2) != 0) return {-1, period + 1};
  return {1, period == 0 ? 0.0 : -period};
}

/// The period that holds least..most up to `slack` at either end; false when none does. Clamping has no periods: what
/// lies beyond the texture reads its edge, which lies amid a page where the texture is cut out.
bool period_of(Wrap wrap, double least, double most, double slack, double& period) {
  period = 0;
  if (least >= -slack && most <= 1 + slack) return true;  // nothing to shift, even where 1 alone is read
  if (wrap == Wrap::clamp) return false;
  period = std::floor((least + most) / 2);
  return least >= period - slack && most <= period + 1 + slack;
}

/// Left, top, right and bottom texel of what a triangle within these ranges reads inside the texture.
std::array<int, 4> cut_footprint(const Range& x, const Range& y, int width, int height) {
  const auto cut = [](double v, int size) { return std::clamp(v, 0.5, size - 0.5); };
  // Cutting the ranges to the outer texels' centres keeps at least one texel for triangles beyond a clamped
  // edge.
  return {std::max(0, first_texel(cut(x.least, width))), std::max(0, first_texel(cut(y.least, height))),
          std::min(width - 1, last_texel(cut(x.most, width))),
          std::min(height - 1, last_texel(cut(y.most, height)))};
}

/// The texel at the centre of a triangle, which bilinear filtering reads there.
std::array<int, 2> centre_of(const Triangle& t, int width, int height) {
  const auto texel = [&](std::size_t axis, int size) {
    return floor_of(std::clamp((t[0][axis] + t[1][axis] + t[2][axis]) / 3, 0.0, size - 0.5));
  };
  return {texel(0, width), texel(1, height)};
}

/// The triangles of a material's uses once each, in texels of the texture; false where some have no UVs.
bool collect(const MaterialUses& uses, int material, const GltfTexture& texture, int width, int height,
             std::vector<Triangle>& out) {
  const GltfScene& scene = uses.scene();
  const UvMatrix matrix = uv_matrix(texture.transform);
  bool all = true;
  for (const GltfUse* each : uses.of(material)) {
    const GltfUse& use = *each;
    if (use.same_uv_as >= 0 || use.world_area.empty()) continue;
    if (texture.uv_set > 1 || use.uv[texture.uv_set].empty() ||
        use.morphed_uv_sets.contains(texture.uv_set)) {
      all = false;
      continue;
    }
    for (const auto& uvs : use.uv[texture.uv_set]) {
      Triangle& triangle = out.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Uv uv = matrix * Uv{uvs[i][0], uvs[i][1]};
        for (const double value : uv)
          if (!(std::abs(value) <= most_uv))
            throw Error::at(scene.path,
                            "UV " + number(value, 6) + " in a triangle of material " +
                                std::to_string(material) + " (" +
                                printable(scene.materials[static_cast<std::size_t>(material)].name) + ")",
                            "a UV between -1e6 and 1e6");
        triangle[i] = {uv[0] * width, uv[1] * height};
      }
    }
  }
  return all;
}

/// Applies two folds, which are in UVs, to corners in texels.
void fold(Triangle& triangle, const PeriodFold& u, const PeriodFold& v, const TexelUse& use) {
  for (Point& p : triangle)
    p = {u.scale * p[0] + u.offset * use.width, v.scale * p[1] + v.offset * use.height};
}

/// Extent in texels of a range of sample positions.
void set_extent(const Range& x, const Range& y, TexelUse& use) {
  const auto bounded = [](double v) { return std::clamp(v, -0x1p29, 0x1p29); };
  const int left = first_texel(bounded(x.least)), top = first_texel(bounded(y.least));
  use.extent = {left, top, last_texel(bounded(x.most)) - left + 1, last_texel(bounded(y.most)) - top + 1};
}

/// The columns and rows, in texels, between which triangles lie.
struct Ranges {
  Range x, y;
  void add(const Triangle& triangle) {
    for (const Point& p : triangle) {
      x.add(p[0]);
      y.add(p[1]);
    }
  }
};
Ranges ranges_of(const std::vector<Triangle>& triangles) {
  Ranges out;
  for (const Triangle& triangle : triangles) out.add(triangle);
  return out;
}

/// Folds all triangles by the one shift that brings them into [0,1]; where there is none, the texture tiles.
/// Sets `tiles`, `fold` and `extent`.
void fold_together(std::vector<Triangle>& triangles, const GltfSampler& sampler, TexelUse& use) {
  if (triangles.empty()) return;
  const int width = use.width, height = use.height;
  const Ranges before = ranges_of(triangles);
  double period_u = 0, period_v = 0;
  const bool one_u =
      period_of(sampler.wrap_u, before.x.least / width, before.x.most / width, 0.5 / width, period_u);
  const bool one_v =
      period_of(sampler.wrap_v, before.y.least / height, before.y.most / height, 0.5 / height, period_v);
  use.tiles = !one_u || !one_v;
  if (!use.tiles) {
    const PeriodFold u = fold_of_period(sampler.wrap_u, period_u),
                     v = fold_of_period(sampler.wrap_v, period_v);
    use.fold = {{u.offset, v.offset}, {u.scale, v.scale}, 0};
    for (Triangle& triangle : triangles) fold(triangle, u, v, use);
  }
  const Ranges after = ranges_of(triangles);
  set_extent(after.x, after.y, use);
}

/// Whether the triangle lies in the texture but for half a texel. One that does not, of a texture that tiles,
/// is folded by itself where it lies in one period; where it does not, the use is not foldable.
bool fold_alone(Triangle& triangle, const GltfSampler& sampler, TexelUse& use) {
  const double slack_u = 0.5 / use.width, slack_v = 0.5 / use.height;
  Range u, v;
  for (const Point& p : triangle) {
    u.add(p[0] / use.width);
    v.add(p[1] / use.height);
  }
  if (u.least >= -slack_u && u.most <= 1 + slack_u && v.least >= -slack_v && v.most <= 1 + slack_v)
    return true;
  if (!use.tiles) return false;
  double period_u = 0, period_v = 0;
  const bool fits = period_of(sampler.wrap_u, u.least, u.most, slack_u, period_u) &&
                    period_of(sampler.wrap_v, v.least, v.most, slack_v, period_v);
  use.foldable = use.foldable && fits;
  if (!fits) return false;
  fold(triangle, fold_of_period(sampler.wrap_u, period_u), fold_of_period(sampler.wrap_v, period_v), use);
  return sampler.wrap_u != Wrap::clamp && sampler.wrap_v != Wrap::clamp;
}

/// Marks the texels of every triangle and keeps its footprint.
void mark_all(std::vector<Triangle>& triangles, const GltfSampler& sampler, Raster& raster, TexelUse& use) {
  use.footprints.reserve(triangles.size());
  for (Triangle& triangle : triangles) {
    const bool inside = fold_alone(triangle, sampler, use);
    raster.triangle(triangle, inside);
    if (!use.foldable) continue;
    Ranges in;
    in.add(triangle);
    const auto footprint = cut_footprint(in.x, in.y, use.width, use.height);
    auto& kept = use.footprints.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) kept[i] = static_cast<std::int16_t>(footprint[i]);
    const auto [column, row] = centre_of(triangle, use.width, use.height);
    use.centres.push_back({static_cast<std::int16_t>(column), static_cast<std::int16_t>(row)});
  }
}

/// Box of what the mask holds, and how much that is.
void measure(TexelUse& use) {
  const auto width = static_cast<std::size_t>(use.width);
  int left = use.width, right = -1, top = use.height, bottom = -1;
  for (int row = 0; row < use.height; ++row) {
    const std::uint8_t* texels = use.mask.data() + static_cast<std::size_t>(row) * width;
    std::size_t in_row = 0;
    for (std::size_t i = 0; i < width; ++i) in_row += texels[i];
    if (in_row == 0) continue;
    use.touched += in_row;
    top = std::min(top, row);
    bottom = row;
    const auto* first = static_cast<const std::uint8_t*>(std::memchr(texels, 1, width));
    left = std::min(left, static_cast<int>(first - texels));
    int last = use.width - 1;
    while (last > right && texels[last] == 0) --last;
    right = std::max(right, last);
  }
  if (use.tiles)
    use.box = {0, 0, use.width, use.height};
  else if (use.touched > 0)
    use.box = {left, top, right - left + 1, bottom - top + 1};
}

}  // namespace

std::optional<Footprint> footprint_of(const std::array<Uv, 3>& uv, const GltfSampler& sampler, int width,
                                      int height) {
  Range u, v;
  for (const Uv& corner : uv) {
    u.add(corner[0]);
    v.add(corner[1]);
  }
  double period_u = 0, period_v = 0;
  if (!period_of(sampler.wrap_u, u.least, u.most, 0.5 / width, period_u) ||
      !period_of(sampler.wrap_v, v.least, v.most, 0.5 / height, period_v))
    return std::nullopt;
  const PeriodFold in_u = fold_of_period(sampler.wrap_u, period_u),
                   in_v = fold_of_period(sampler.wrap_v, period_v);
  Triangle folded;
  for (std::size_t i = 0; i < 3; ++i)
    folded[i] = {(in_u.scale * uv[i][0] + in_u.offset) * width,
                 (in_v.scale * uv[i][1] + in_v.offset) * height};
  Ranges in;
  in.add(folded);
  return Footprint{cut_footprint(in.x, in.y, width, height),
                   centre_of(folded, width, height),
                   {{in_u.offset, in_v.offset}, {in_u.scale, in_v.scale}, 0}};
}

TexelUse texel_use(const GltfScene& scene, int material, const GltfTexture& texture, int width, int height) {
  return texel_use(MaterialUses(scene), material, texture, width, height);
}

TexelUse texel_use(const MaterialUses& uses, int material, const GltfTexture& texture, int width,
                   int height) {
  assert(width > 0 && height > 0 && width <= 32767 && height <= 32767);
  TexelUse use;
  use.width = width;
  use.height = height;
  use.mask.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  std::vector<Triangle> triangles;
  const bool all_have_uvs = collect(uses, material, texture, width, height, triangles);
  fold_together(triangles, texture.sampler, use);
  Raster raster(use, texture.sampler.wrap_u, texture.sampler.wrap_v);
  mark_all(triangles, texture.sampler, raster, use);
  if (!all_have_uvs) {
    raster.everything();
    use.extent = {0, 0, width, height};
    use.foldable = false;
  }
  if (!use.foldable) use.footprints.clear(), use.centres.clear();
  measure(use);
  return use;
}

std::vector<std::uint8_t> texels_read(const TexelUse& use, const GltfSampler& sampler) {
  std::vector<std::uint8_t> out = use.mask;
  if (use.tiles) return out;
  const auto [x, y, width, height] = use.extent;
  const auto texel = [&](int column, int row) -> std::uint8_t& {
    return out[static_cast<std::size_t>(row) * static_cast<std::size_t>(use.width) +
               static_cast<std::size_t>(column)];
  };
  const int right = use.width - 1, bottom = use.height - 1;
  // Clamping and mirroring lead to the texels at the border itself.
  if (sampler.wrap_u == Wrap::repeat)
    for (int row = 0; row < use.height; ++row) {
      const std::uint8_t left_read = texel(0, row), right_read = texel(right, row);
      if (x < 0) texel(right, row) |= left_read;
      if (x + width > use.width) texel(0, row) |= right_read;
    }
  if (sampler.wrap_v == Wrap::repeat)
    for (int column = 0; column < use.width; ++column) {
      const std::uint8_t top_read = texel(column, 0), bottom_read = texel(column, bottom);
      if (y < 0) texel(column, bottom) |= top_read;
      if (y + height > use.height) texel(column, 0) |= bottom_read;
    }
  return out;
}

}  // namespace etak
