// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/targets/target.h"

namespace etak {

/// n and k of red, green and blue that give F0 and F82, and the larger of what they miss of the two. Without a known edge k is 0
/// and n gives F0.
struct RgbIndex {
  LinearRgb n, k, residual;
};
RgbIndex rgb_index(const ExportSurface& surface);

/// The Changes of F0 and F82 that n and k do not give.
void note_residual(const TargetJob& job, const RgbIndex& index);

}  // namespace etak
