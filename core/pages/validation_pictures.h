// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "core/image/image.h"
#include "core/validate/settings.h"

namespace etak {

/// The picture no larger than `most` on a side, each new pixel the mean of the light it covers (codes taken
/// as sRGB); RGB. Smaller pictures stay as they are.
Image8 thumbnail(const Image8& picture, int most);

/// Where marks (region_picture in core/validate/engine.h) lie, for laying over thumbnail(): RGBA with
/// straight opacity, red where a pixel covers plateau, else yellow where it covers transition, the stronger
/// the more.
Image8 heat_map(const Image8& marks, int width, int height);

/// Texels of F0 by the 8-bit code of their luminance under `transfer`. Texels with opacity 0 in `diffuse` (4
/// channels, of the same size; may be empty) are left out.
std::array<std::size_t, 256> f0_histogram(const Image8& specular, const Image8& diffuse,
                                          TextureTransfer transfer);

/// What a code stands for under `transfer`, in [0, 1], and back (not rounded).
double decoded(double code, TextureTransfer transfer);
double encoded(double linear, TextureTransfer transfer);

}  // namespace etak
