// SPDX-License-Identifier: Apache-2.0
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

// Turns green around; the other channels stay. Where the relief agrees with itself by less than the rule asks of an error,
// parts of the surface may be mirrored in the texture.
RepairOutcome turn_green(const RepairBench& bench) {
  RepairPicture* map = bench.named();
  if (map == nullptr || map->codes.channels < 3) return {"", "the map has no three channels"};
  if (bench.finding.severity < Severity::error)
    return {"", "the relief agrees to less than 70 %, so that parts of the surface may be mirrored"};
  const auto channels = static_cast<std::size_t>(map->codes.channels);
  for (std::size_t i = 1; i < map->codes.values.size(); i += channels)
    map->codes.values[i] = static_cast<std::uint16_t>(map->most - map->codes.values[i]);
  return {"turned green around"};
}

}  // namespace

constinit const Repair repair_etk703{"ETK703", &turn_green};

}  // namespace etak
