// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace etak {

/// Limits of the byte tests in codes. They are made from the settings by the code tables, so that no test of
/// the byte pass needs a float.
struct ByteLimits {
  static constexpr int b_levels = 4, a_levels = 2;
  // Codes of alpha that ETK501 looks at: outside of them premultiplied colour is too near to black, or to
  // straight colour, to be recognised.
  static constexpr std::uint8_t alpha_middle_first = 9, alpha_middle_last = 246;
  std::uint8_t zone_first = 124, zone_last = 178;       // codes of a grey in the forbidden zone, inclusive
  std::uint8_t b_level[b_levels] = {36, 81, 124, 179};  // least grey code at or above each limit of Y, 1..255
  std::uint8_t a_level[a_levels] = {30, 251};
  std::uint8_t spread = 4;           // largest difference of a dielectric's channels
  std::uint8_t bluish = 12;          // bluish: blue is above red by more than this
  std::uint8_t metal_diffuse = 30;   // largest diffuse channel that a metal may have
  std::uint8_t black_diffuse = 2;    // largest diffuse channel of black
  std::uint8_t single_bright = 124;  // single channel: one diffuse channel above this, and one at 0
};

/// Masks of 64 texels, bit i for texel i. A texel is surely below a level of Y when its largest channel is,
/// and surely at or above it when its smallest channel is; for other texels the sums of the tables decide.
struct MaskWords {
  std::uint64_t opaque;
  std::uint64_t alpha_zero, alpha_full, alpha_middle;  // 0; 255; the middle codes
  std::uint64_t zone_any, zone_all;                    // channels of B in the zone's codes
  std::uint64_t black, nearly_black;                   // B: all 0; all at most 1
  std::uint64_t spread;                                // B: largest - smallest channel > spread
  std::uint64_t bluish;                                // B: blue - red > bluish
  std::uint64_t b_below[ByteLimits::b_levels], b_from[ByteLimits::b_levels];
  std::uint64_t a_below[ByteLimits::a_levels], a_from[ByteLimits::a_levels];
  std::uint64_t diffuse_on_metal, diffuse_black, single_channel;  // A
  std::uint64_t energy_doubt;  // some channel where the codes of A and B add up to 256 or more: only there
                               // can the linear sum pass 1, because the curves are convex
  std::uint64_t gloss_zero, gloss_full;
};

/// Exact counts over the texels. Opaque texels are those of alpha 255 where alpha is transparency, else those
/// of alpha above 0.
struct MaskCounts {
  std::uint64_t opaque = 0, alpha_zero = 0, alpha_full = 0, zone_any = 0, zone_all = 0, black = 0;
  std::uint64_t gloss_zero = 0, gloss_full = 0;    // of opaque texels
  std::uint64_t gloss_sum = 0, gloss_squares = 0;  // of texels with alpha above 0
  std::uint8_t gloss_least = 255, gloss_most = 0;  // of all
};

/// Makes the masks and counts of 64 x `words` texels of A and B, 4 bytes a texel. `valid` tells which of the
/// last 64 texels count; the others must repeat one that does, with alpha 0. All versions give the same
/// result.
using ByteMasks = void (*)(const std::uint8_t* a, const std::uint8_t* b, std::size_t words,
                           std::uint64_t valid, bool transparency, const ByteLimits& limits, MaskWords* out,
                           MaskCounts& counts);
/// The fastest version for this processor.
ByteMasks byte_masks();

/// The two versions. byte_masks_avx2() exists on x86-64 only; what it returns may be called only where the
/// processor has AVX2 and POPCNT.
ByteMasks byte_masks_avx2();
ByteMasks byte_masks_plain();

}  // namespace etak
