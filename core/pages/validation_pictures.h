// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "core/image/image.h"
#include "core/judge/settings.h"

namespace etak {

/// The picture as RGB, reduced so that no side is longer than `most`; smaller pictures keep their size. Each
/// pixel is the mean over the texels that it covers, taken in linear light; codes are read as sRGB.
Image8 thumbnail(const Image8& picture, int most);

/// An overlay for thumbnail() that shows where marks (region_picture in core/judge/engine.h) lie: RGBA
/// with straight (not premultiplied) opacity. Pixels that cover plateau texels are red; pixels that cover
/// transition texels alone are yellow. Opacity grows with the share of such texels.
Image8 heat_map(const Image8& marks, int width, int height);

/// The number of texels of F0 for each 8-bit code of their luminance under `transfer`.
///   diffuse   where it has 4 channels and the same size: texels of opacity 0 are not counted; may be empty
std::array<std::size_t, 256> f0_histogram(const Image8& specular, const Image8& diffuse,
                                          TextureTransfer transfer);

/// The linear value in [0, 1] of a code in [0, 255] under `transfer`.
double decoded(double code, TextureTransfer transfer);
/// The code of a linear value under `transfer`, not rounded.
double encoded(double linear, TextureTransfer transfer);

}  // namespace etak
