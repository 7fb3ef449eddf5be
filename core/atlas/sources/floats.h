// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/atlas/leave_out.h"
#include "core/atlas/sources/sources.h"
#include "core/image/picture.h"

namespace etak {

// Materials as floats, for outputs that hold floats: from the numbers of the files, not from 8-bit codes.

/// A picture as floats, codes as fractions of full scale.
Image fractions(Picture picture);

/// One plane at its full size: a colour in linear light (three channels) or a grey quantity (one). Values
/// outside of 0..1 stay. Throws Error: what PlaneRows throws, and for values that are not finite.
Image plane_floats(const PlaneSource& source, int width, int height);

/// Both textures of a material at its size. What its pictures do not say is constant.
FloatPair load_floats(const PackInput& material);

/// A linear channel of base colour c and metalness m: diffuse = c (1 - m), F0 = 0.04 (1 - m) + c m.
struct MetallicChannel {
  double diffuse, f0;
};
inline MetallicChannel metallic_channel(double base, double metallic) {
  return {base * (1 - metallic), 0.04 + (base - 0.04) * metallic};
}

/// Both textures of base colour and metalness, by metallic_channel().
FloatPair metallic_floats(const PlaneSource& base, const PlaneSource& alpha, const PlaneSource& metallic,
                          const PlaneSource& gloss, int width, int height);

}  // namespace etak
