// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

// The round lobes through which an environment is prefiltered: Schueler's lobe of nine glosses from 1 to 0, seen along
// the normal. With the half vector distribution nh^e and Kelemen's 1 / lh^2, f nl is nh^(e - 2) nl up to a factor, and
// nh^2 = (1 + nl) / 2, so that the lobe depends on the cosine with its axis alone.

inline constexpr int lobe_levels = 9;

/// The gloss of a level, 1 for level 0 to 0 for the last one; and back.
constexpr double gloss_of_level(double level) {
  return 1 - level / (lobe_levels - 1);
}

constexpr double level_of_gloss(double gloss) {
  return (1 - gloss) * (lobe_levels - 1);
}

/// The lobe of exponent `e` at the cosine `c` with its axis, up to a factor that does not depend on c; 0 for c <= 0.
double round_lobe(double e, double c);

/// The share of a lobe that lies beyond a plane through the point that it is seen from.
///   level   [0, lobe_levels - 1], linear between whole levels
///   angle   from the lobe's axis to the plane, radians: below 0 the axis is before the plane, and the share is below 1/2
///   error   below 0.002
double share_beyond(double level, double angle);

}  // namespace etak
