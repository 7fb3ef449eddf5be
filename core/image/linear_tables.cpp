// SPDX-License-Identifier: Apache-2.0
#include "core/image/linear_tables.h"

#include <cmath>
#include <limits>

#include "core/color/gloss.h"
#include "core/color/srgb.h"

namespace etak {
namespace {

// The least float that is not below `value`, and the largest that is not above it: floats compare with them
// as with the value itself.
float not_below(double value) {
  const auto near = static_cast<float>(value);
  return double{near} < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}
float not_above(double value) {
  const auto near = static_cast<float>(value);
  return double{near} > value ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

LinearTables built() {
  LinearTables t{};
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (std::size_t c = 0; c < 256; ++c) {
    const auto code = static_cast<double>(c);
    t.srgb[c] = static_cast<float>(srgb_decode(code / 255));
    t.inverse[c] = static_cast<float>(variance_of_gloss(code / 255));
    t.srgb_step[c] = c == 0 ? -infinity : not_below(srgb_decode((code - 0.5) / 255));
    t.gloss_step[c] = c == 0 ? infinity : not_above(variance_of_gloss((code - 0.5) / 255));
  }
  t.srgb_step[256] = infinity;

  // The guess of a slot is the code at its lower end; a conversion then compares with the one step that the
  // slot may hold. For gloss, codes fall as 1/e grows.
  for (std::size_t slot = 0, code = 0; slot < t.srgb_guess.size(); ++slot) {
    const auto lower = static_cast<float>(static_cast<double>(slot) / LinearTables::srgb_slots);
    while (lower >= t.srgb_step[code + 1]) ++code;
    t.srgb_guess[slot] = static_cast<std::uint8_t>(code);
  }
  for (std::size_t slot = 0, code = 255; slot < t.gloss_guess.size(); ++slot) {
    const auto octave = static_cast<int>(slot) / LinearTables::slots_per_octave - LinearTables::octaves;
    const double part =
        static_cast<double>(slot % LinearTables::slots_per_octave) / LinearTables::slots_per_octave;
    const auto lower = static_cast<float>(std::ldexp(1 + part, octave));
    while (lower > t.gloss_step[code]) --code;
    t.gloss_guess[slot] = static_cast<std::uint8_t>(code);
  }
  return t;
}

}  // namespace

const LinearTables& linear_tables() {
  static const LinearTables tables = built();
  return tables;
}

}  // namespace etak
