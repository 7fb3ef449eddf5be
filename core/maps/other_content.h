// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/maps/map_evidence.h"

namespace etak {

// What tells that a picture holds something else than its role says.

/// Whether a texel cannot be that of a grey picture: its three codes differ by more than 10. JPEG makes less of grey.
inline bool is_coloured(const std::uint8_t* rgb) {
  const auto [least, most] = std::minmax({rgb[0], rgb[1], rgb[2]});
  return most - least > 10;
}

/// Sums over the texels of a picture, by which one of normals is told from one of colours. Components are those of a
/// normal map, -1 to 1.
///   unit     texels whose length is 1 within 0.05, and whose z is not below 0
///   leaning  x: red's component, y: green's
///   lengths  x: the length, y: blue's component
struct NormalSums {
  std::uint64_t unit = 0;
  PairSums leaning, lengths;

  /// Adds a texel of three codes.
  void add(const std::uint8_t* rgb);
  /// Share of the texels that are unit; 0 for none.
  double unit_share() const;
};

/// Whether the texels are normals of a tangent space. Colours become brighter and darker, by which their lengths vary
/// as much as their components do; normals turn while their length stays. So red and green must vary by 1.5 codes or
/// more, about a mean that leans by no more than that, the length by no more than a third of it, eight of ten texels be
/// unit, and the mean stand up. Of the ten normal maps of four real scenes nine vary by 2 to 25 codes, the length by
/// 0.04 to 0.26 of that, and 86 % or more are unit; of their base colours at most 13 % are.
/// A picture of one colour is none, whatever the colour.
bool are_normals(const NormalSums& sums);

}  // namespace etak
