// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/mat3.h"

namespace etak {

/// Weights of red, green and blue in the luminance of linear Rec. 709, which is linear sRGB: the four digits
/// that ITU-R BT.709-6 (item 3.2) prints. Pictures, masks and rules use them as shaders do (luminance_of() of
/// core/light/marks.glsl). The primaries give more digits (rgb_to_xyz() in core/color/colorspace.h: 0.21264,
/// 0.71517, 0.07219): F0 and exports, which know other spaces too, take Y from there.
template <class Real>
inline constexpr Real luminance_weights[] = {Real(0.2126), Real(0.7152), Real(0.0722)};

/// Luminance Y of linear Rec. 709 or sRGB, in the unit of the channels; (1, 1, 1) has 1.
template <class Real>
constexpr Real luminance_of(Real r, Real g, Real b) {
  return luminance_weights<Real>[0] * r + luminance_weights<Real>[1] * g + luminance_weights<Real>[2] * b;
}
constexpr double luminance_of(const Vec3& rgb) {
  return luminance_of(rgb[0], rgb[1], rgb[2]);
}

}  // namespace etak
