// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/number.h"
#include "core/math/functions.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

// Length in units of 1 from which a texel is made unit again; rounding to 8 bits alone makes 0.9 codes of
// 127.5.
constexpr double most_off = 1 / 127.5;

// Beyond this the mean normal is not that of a surface with a wrong length here and there, in degrees.
constexpr double most_lean = 10;

// Angle between the mean of a map and straight up, in degrees.
double lean_of(const RepairPicture& map) {
  const auto channels = static_cast<std::size_t>(map.codes.channels);
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < map.codes.values.size(); i += channels)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += 2 * map.value(map.codes.values[i + c]) - 1;
  return math::atan2(math::hypot(sum[0], sum[1]), sum[2]) * 180 / std::numbers::pi;
}

// Makes the texels unit whose length is wrong, along their own direction.
RepairOutcome make_unit(const RepairBench& bench) {
  RepairPicture* map = bench.named();
  if (map == nullptr || map->codes.channels < 3) return {"", "the map has no three channels"};
  const auto channels = static_cast<std::size_t>(map->codes.channels);
  if (const double lean = lean_of(*map); lean > most_lean)
    return {"", "the mean normal leans by " + number(lean, 2) +
                    " degrees, so more than the lengths is wrong: unit length would hide it"};
  std::size_t without = 0;
  for (std::size_t i = 0; i < map->codes.values.size(); i += channels) {
    std::array<double, 3> n{};
    double squared = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      n[c] = 2 * map->value(map->codes.values[i + c]) - 1;
      squared += n[c] * n[c];
    }
    const double length = std::sqrt(squared);
    if (std::abs(length - 1) <= most_off) continue;
    // Texels as short as rounding itself have no direction.
    if (length < 4 * most_off) {
      ++without;
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) map->codes.values[i + c] = map->code((n[c] / length + 1) / 2);
  }
  return {"made the normals unit",
          without == 0 ? "" : std::to_string(without) + " texels are too short to have a direction"};
}

}  // namespace

constinit const Repair repair_etk701{"ETK701", &make_unit};
// The lengths that shrinking took come back by this repair too; the relief that it took does not.
constinit const Repair repair_etk706{"ETK706", &make_unit};

}  // namespace etak
