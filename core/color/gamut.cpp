// SPDX-License-Identifier: Apache-2.0
#include "core/color/gamut.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"

namespace etak {
namespace {

constexpr double tolerance = 1e-9;
constexpr int digits = 3;

}  // namespace

std::array<double, 3> gamut_excess(const LinearRgb& color) {
  std::array<double, 3> out{};
  const std::array<double, 3> channels{color.r, color.g, color.b};
  for (std::size_t c = 0; c < 3; ++c) {
    const double excess = channels[c] > 1 ? channels[c] - 1 : std::min(channels[c], 0.0);
    if (std::abs(excess) > tolerance) out[c] = excess;
  }
  return out;
}

std::string gamut_text(const LinearRgb& color) {
  const std::array<double, 3> excess = gamut_excess(color);
  std::string out;
  for (std::size_t c = 0; c < 3; ++c) {
    if (excess[c] == 0) continue;
    if (!out.empty()) out += ", ";
    out += "rgb"[c];
    out += excess[c] > 0 ? " +" : " ";
    append_number(out, excess[c], digits);
  }
  return out;
}

}  // namespace etak
