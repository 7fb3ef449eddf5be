// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/channels.h"
#include "core/image/image.h"

namespace etak {

/// Both textures of a material in memory, of one size, RGBA.
struct MaterialPair {
  Image8 diffuse_alpha, specular_gloss;
  const Image8& of(Texture texture) const {
    return texture == Texture::diffuse_alpha ? diffuse_alpha : specular_gloss;
  }
};

/// The same as floats: colours in linear light, alpha and gloss as they are, nothing clamped.
struct FloatPair {
  Image diffuse_alpha, specular_gloss;
};

}  // namespace etak
