// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/color/luminance.h"
#include "core/image/image.h"
#include "core/math/functions.h"
#include "core/math/mat3.h"

namespace etak {

// Latitude-longitude maps of radiance, as class Environment says.

inline double luminance_at(const Image& map, int x, int y) {
  const float* rgb = map.at(x, y).data();
  return luminance_of<double>(rgb[0], rgb[1], rgb[2]);
}

/// A row of a map by its sine and cosine, which all directions of the row share.
struct MapRow {
  explicit MapRow(double v)
      : sine(math::sin(std::numbers::pi * v)), cosine(math::cos(std::numbers::pi * v)) {}
  double sine, cosine;
};
inline Vec3 direction_at(double u, const MapRow& row) {
  const double phi = 2 * std::numbers::pi * (u - 0.5);
  return {row.sine * math::sin(phi), row.cosine, -row.sine * math::cos(phi)};
}

struct MapPlace {
  double u, v;
};
inline MapPlace place_of(const Vec3& d) {
  // Both angles are computed by atan2, because acos loses digits towards the poles.
  return {0.5 + math::atan2(d[0], -d[2]) / (2 * std::numbers::pi),
          math::atan2(std::sqrt(d[0] * d[0] + d[2] * d[2]), d[1]) / std::numbers::pi};
}

// The bilinear value at a place. Columns wrap around; rows end at the poles.
inline Vec3 look_up(const Image& map, const MapPlace& place) {
  const double x = place.u * map.width - 0.5,
               y = std::clamp(place.v * map.height - 0.5, 0.0, map.height - 1.0);
  const double column = std::floor(x), row = std::floor(y);
  const double fx = x - column, fy = y - row;
  const auto wrap = [&](int i) { return i < 0 ? i + map.width : i >= map.width ? i - map.width : i; };
  const int x0 = wrap(static_cast<int>(column)), x1 = wrap(static_cast<int>(column) + 1);
  const int y0 = static_cast<int>(row), y1 = std::min(y0 + 1, map.height - 1);
  const auto a = map.at(x0, y0), b = map.at(x1, y0), c = map.at(x0, y1), d = map.at(x1, y1);
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = (double{a[i]} * (1 - fx) + double{b[i]} * fx) * (1 - fy) +
             (double{c[i]} * (1 - fx) + double{d[i]} * fx) * fy;
  return out;
}

// The solid angle of a pixel in `row` of a map, in sr.
inline double solid_angle(const Image& map, int row) {
  const double top = math::cos(std::numbers::pi * row / map.height),
               bottom = math::cos(std::numbers::pi * (row + 1) / map.height);
  return 2 * std::numbers::pi / map.width * (top - bottom);
}

}  // namespace etak
