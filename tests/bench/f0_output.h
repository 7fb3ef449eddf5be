// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>

namespace bench {

/// One spectrum's F0 as a program wrote it: linear sRGB, unclipped, and its 8-bit codes.
struct F0Values {
  std::array<double, 3> linear{};
  std::array<int, 3> codes{};
};

/// Page name (without ".yml") to values; pages without numbers (refused ones) are left out.
using F0Output = std::map<std::string, F0Values>;

/// Reads the CSV of `etak f0` (columns path, r, g, b, u8_r, u8_g, u8_b) or of a peer (name, R, G, B, r8, g8,
/// b8), in any order and among others. Throws std::runtime_error when a column is missing.
F0Output read_f0_csv(const std::string& file);

/// How far `other` is from `reference` over the pages that both hold.
struct Deviation {
  std::size_t compared = 0, missing = 0;  // missing: in the reference only
  double linear = 0;                      // largest difference of a linear channel
  std::string worst_page;                 // where
  std::size_t codes_changed = 0;          // pages with an 8-bit code that differs
  int codes = 0;                          // largest difference of a code
};
Deviation deviation(const F0Output& reference, const F0Output& other);

/// "906 rows, |dlin| 2.0e-06, 0 u8"
std::string text(const Deviation& deviation);

}  // namespace bench
