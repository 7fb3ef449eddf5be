// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arithmetic with colours for the values of targets; for engine_values.cpp and format_values.cpp only.

#include <algorithm>
#include <vector>

#include "core/color/rgb.h"

namespace etak {

inline std::vector<double> list(const LinearRgb& c) {
  return {c.r, c.g, c.b};
}
inline LinearRgb grey(double value) {
  return {value, value, value};
}
inline LinearRgb scaled(const LinearRgb& c, double factor) {
  return {c.r * factor, c.g * factor, c.b * factor};
}
inline double largest(const LinearRgb& c) {
  return std::max({c.r, c.g, c.b});
}
inline double smallest(const LinearRgb& c) {
  return std::min({c.r, c.g, c.b});
}

}  // namespace etak
