// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/light_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/render/ambient/lat_long.h"

namespace etak {
namespace {

// Each texel of level 0 is the mean of so many radiances in both directions.
constexpr int samples_per_side = 3;

// The direction at a place of the octahedral square, not of unit length: its coordinates sum up to 1.
Vec3 octahedral_direction(double u, double v) {
  const double x = 2 * u - 1, z = 2 * v - 1, y = 1 - std::abs(x) - std::abs(z);
  if (y >= 0) return {x, y, z};
  return {std::copysign(1 - std::abs(z), x), y, std::copysign(1 - std::abs(x), z)};
}

// Of a texel of a level; up to a factor that is the same for all.
double texel_angle(int x, int y, int side) {
  const Vec3 d = octahedral_direction((x + 0.5) / side, (y + 0.5) / side);
  return std::pow(dot(d, d), -1.5);
}

Image halved(const Image& level) {
  Image out(level.width / 2, level.height / 2, 3);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      double sum[3] = {}, total = 0;
      for (int i = 0; i < 4; ++i) {
        const int column = 2 * x + i % 2, row = 2 * y + i / 2;
        const double weight = texel_angle(column, row, level.width);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * double{level.at(column, row)[c]};
        total += weight;
      }
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y)[c] = static_cast<float>(sum[c] / total);
    }
  return out;
}

// Copies a level with its border, whose texels are those that lie next to the edge on the sphere.
void place(const Image& level, int left, int top, Image& picture) {
  const int side = level.width;
  for (int y = -1; y <= side; ++y)
    for (int x = -1; x <= side; ++x) {
      int column = x, row = y;
      if (column < 0 || column >= side) {
        column = column < 0 ? 0 : side - 1;
        row = side - 1 - row;
      }
      if (row < 0 || row >= side) {
        row = row < 0 ? 0 : side - 1;
        column = side - 1 - column;
      }
      std::copy_n(level.at(column, row).data(), 3, picture.at(left + x, top + y).data());
    }
}

// The bright part of a map, as directional lights: places of a lattice in the integral of its luminance.
Image bright_lights(const Image& bright) {
  std::vector<double> rows, columns;  // cumulated over the rows, and in each row over its columns
  double total = 0;
  for (int y = 0; y < bright.height; ++y) {
    double row = 0;
    for (int x = 0; x < bright.width; ++x)
      columns.push_back(row += luminance_at(bright, x, y) * solid_angle(bright, y));
    rows.push_back(total += row);
  }
  if (!(total > 0)) return {};
  Image out(RefinedLight::bright_count, 2, 3);
  for (int i = 0; i < out.width; ++i) {
    const double turns = i / std::numbers::phi, wanted = total * (i + 0.5) / out.width;
    const auto y = std::upper_bound(rows.begin(), rows.end() - 1, wanted) - rows.begin();
    const auto first = columns.begin() + y * bright.width;
    const double in_row = first[bright.width - 1] * (turns - std::floor(turns));
    const auto x = std::upper_bound(first, first + bright.width - 1, in_row) - first;
    const double above = y == 0 ? 0 : rows[std::size_t(y - 1)], before = x == 0 ? 0 : first[x - 1];
    const double down = (wanted - above) / (rows[std::size_t(y)] - above),
                 along = (in_row - before) / (first[x] - before);
    const Vec3 d = direction_at((double(x) + along) / bright.width, (double(y) + down) / bright.height);
    const auto rgb = bright.at(int(x), int(y));
    const double factor = total / out.width / luminance_at(bright, int(x), int(y));
    for (std::size_t c = 0; c < 3; ++c) {
      out.at(i, 0)[c] = static_cast<float>(d[c]);
      out.at(i, 1)[c] = static_cast<float>(double{rgb[c]} * factor);
    }
  }
  return out;
}

}  // namespace

RefinedLight refined_light(const Image& lat_long, unsigned threads) {
  Image dim = lat_long, bright = lat_long;
  double mean = 0;
  for (int y = 0; y < dim.height; ++y)
    for (int x = 0; x < dim.width; ++x)
      mean += luminance_at(dim, x, y) * solid_angle(dim, y) / (4 * std::numbers::pi);
  for (int y = 0; y < dim.height; ++y)
    for (int x = 0; x < dim.width; ++x) {
      const double here = luminance_at(lat_long, x, y), share = here > mean ? mean / here : 1;
      for (std::size_t c = 0; c < 3; ++c) {
        dim.at(x, y)[c] = static_cast<float>(double{lat_long.at(x, y)[c]} * share);
        bright.at(x, y)[c] = share < 1 ? lat_long.at(x, y)[c] - dim.at(x, y)[c] : 0;
      }
    }
  const int side = std::clamp(int(std::bit_ceil(unsigned(dim.width))) / 2, 16, 512);
  const auto map_of = [&](const Image& map) {
    return LightMap([&](const Vec3& d) { return look_up(map, place_of(d)); }, side, threads);
  };
  return {map_of(lat_long), map_of(dim), bright_lights(bright)};
}

LightMap::LightMap(const std::function<Vec3(const Vec3&)>& radiance, int side, unsigned threads)
    : picture_(side + 2 + std::max(side / 2, 1) + 2, side + 2 + 2 * std::countr_zero(unsigned(side)), 3),
      side_(side) {
  Image level(side, side, 3);
  parallel_chunks(std::size_t(side), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < side; ++x) {
        Vec3 sum{};
        for (int i = 0; i < samples_per_side * samples_per_side; ++i) {
          const Vec3 d = octahedral_direction((x + (i % samples_per_side + 0.5) / samples_per_side) / side,
                                              (y + (i / samples_per_side + 0.5) / samples_per_side) / side);
          const Vec3 seen = radiance(scaled(d, 1 / std::sqrt(dot(d, d))));
          for (std::size_t c = 0; c < 3; ++c) sum[c] += seen[c] / (samples_per_side * samples_per_side);
        }
        for (std::size_t c = 0; c < 3; ++c) level.at(x, y)[c] = static_cast<float>(sum[c]);
      }
  });
  place(level, 1, 1, picture_);
  for (int i = 1; i <= last_level(); ++i) {
    level = halved(level);
    place(level, side + 3, side - 2 * level.width + 2 * i - 1, picture_);
  }
}

int LightMap::last_level() const {
  return std::countr_zero(unsigned(side_));
}

}  // namespace etak
