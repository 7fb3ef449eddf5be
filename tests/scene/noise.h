// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

// Noise for the demo's pictures: whole-number hashes and polynomials, so that every machine draws the same.
// Based on: Perlin 2002, "Improving Noise" (gradients on a lattice, quintic fade).
namespace etak::demo {

inline std::uint32_t hashed(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return h ^ h >> 15;
}

/// [0, 1).
inline double random_at(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return hashed(x, y, seed) / 4294967296.0;
}

/// Smooth, about [-1, 1], with period 1 in u and v.
///   cells_u, cells_v   lattice cells in a period
inline double noise(double u, double v, int cells_u, int cells_v, std::uint32_t seed) {
  const double x = u * cells_u, y = v * cells_v;
  const double fx = std::floor(x), fy = std::floor(y), dx = x - fx, dy = y - fy;
  const auto corner = [&](int i, int j) {
    const auto wrapped = [](double at, int cells) {
      const int m = static_cast<int>(at) % cells;
      return static_cast<std::uint32_t>(m < 0 ? m + cells : m);
    };
    const std::uint32_t pick = hashed(wrapped(fx + i, cells_u), wrapped(fy + j, cells_v), seed) & 7;
    constexpr double gradients[8][2] = {{1, 1},   {-1, 1},   {1, -1},  {-1, -1},
                                        {1.4, 0}, {-1.4, 0}, {0, 1.4}, {0, -1.4}};
    return gradients[pick][0] * (dx - i) + gradients[pick][1] * (dy - j);
  };
  const auto fade = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
  const double sx = fade(dx), upper = corner(0, 0) + sx * (corner(1, 0) - corner(0, 0));
  const double lower = corner(0, 1) + sx * (corner(1, 1) - corner(0, 1));
  return upper + fade(dy) * (lower - upper);
}

/// Octaves of noise, each twice as fine and half as strong.
inline double octaves(double u, double v, int cells_u, int cells_v, int count, std::uint32_t seed) {
  double sum = 0, weight = 0.5;
  for (int i = 0; i < count; ++i, weight /= 2)
    sum += weight * noise(u, v, cells_u << i, cells_v << i, seed + static_cast<std::uint32_t>(i));
  return sum;
}

/// 0 below `from`, 1 above `to`, smooth between.
inline double step_between(double from, double to, double x) {
  const double t = (x - from) / (to - from), c = t < 0 ? 0 : t > 1 ? 1 : t;
  return c * c * (3 - 2 * c);
}

}  // namespace etak::demo
