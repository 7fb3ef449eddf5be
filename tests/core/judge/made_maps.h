// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/image/image.h"

/// Made-up reliefs and their maps, for tests.
namespace etak::test {

/// Heights in texels, wrapped round at the edges.
using Heights = Pixels<float>;

/// A relief that follows from the seed.
///   kind   0 noise, 1 uneven bricks, 2 bumps, 3 even bricks
Heights surface(int kind, std::uint64_t seed, int size);

/// The normal map of a relief; green points up.
Image8 normals_of(const Heights& h, double strength = 1);

/// The height map of a relief, from its lowest texel to its highest.
Image8 grey_of(const Heights& h);

/// Half the side, by means of 2 x 2 texels.
Image8 halved(const Image8& large);

/// A picture as a JPEG file holds it.
///   subsampled   chroma has half the side, as most programs write it
Image8 through_jpeg(const Image8& image, int quality, bool subsampled);

}  // namespace etak::test
