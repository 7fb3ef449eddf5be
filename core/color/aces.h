// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

/// Chromaticity of the white of ACES (SMPTE ST 2065-1:2021), which is that of ACEScg.
inline constexpr double aces_white_x = 0.32168, aces_white_y = 0.33767;

}  // namespace etak
