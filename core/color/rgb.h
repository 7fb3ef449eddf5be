// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/math/mat3.h"

namespace etak {

/// CIE tristimulus values, scaled so that a perfect reflector has Y = 1.
struct Xyz {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Xyz&, const Xyz&) = default;
};

/// Linear-light red, green, blue of some colour space; never clipped: values outside [0, 1] are out of its
/// gamut.
struct LinearRgb {
  double r = 0, g = 0, b = 0;
  friend bool operator==(const LinearRgb&, const LinearRgb&) = default;
};

/// 8-bit sRGB codes.
struct Srgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Srgb8&, const Srgb8&) = default;
};

constexpr Vec3 vec(const Xyz& c) {
  return {c.x, c.y, c.z};
}
constexpr Vec3 vec(const LinearRgb& c) {
  return {c.r, c.g, c.b};
}
constexpr Xyz to_xyz(const Vec3& v) {
  return {v[0], v[1], v[2]};
}
constexpr LinearRgb to_rgb(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace etak
