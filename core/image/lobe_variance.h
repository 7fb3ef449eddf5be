// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace etak {

// Gloss is averaged as 1 / e, the variance of its lobe, with Schueler's e = 2^(12 g).

inline float inverse_exponent(float gloss) {
  return std::exp2(-12 * gloss);
}

inline float gloss_of_inverse_exponent(float inverse) {
  return -std::log2(inverse) / 12;
}

}  // namespace etak
