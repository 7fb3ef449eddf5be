// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/color/srgb.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

// Texels whose length is further than a twentieth from 1 once their codes went through `curve`. A sample
// suffices, because the wrong curve leaves next to none of them right.
std::size_t wrong_lengths(const RepairPicture& map, double (*curve)(double)) {
  const std::size_t texels = map.codes.pixel_count(), step = 1 + texels / 65536;
  const auto channels = static_cast<std::size_t>(map.codes.channels);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < texels; i += step) {
    double squared = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double component = 2 * curve(map.value(map.codes.values[i * channels + c])) - 1;
      squared += component * component;
    }
    wrong += std::abs(std::sqrt(squared) - 1) > 0.05;
  }
  return wrong;
}

RepairOutcome undo_curve(const RepairBench& bench) {
  RepairPicture* map = bench.named();
  if (map == nullptr || map->codes.channels < 3) return {"", "the map has no three channels"};
  using Curve = double (*)(double);
  const Curve decode = srgb_decode, encode = srgb_encode;
  const bool is_encoded = wrong_lengths(*map, decode) < wrong_lengths(*map, encode);
  map->put_through(is_encoded ? decode : encode);
  return {is_encoded ? "undid the sRGB encoding of the normals" : "undid the sRGB decoding of the normals"};
}

}  // namespace

constinit const Repair repair_etk704{"ETK704", &undo_curve};

}  // namespace etak
