// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/channels.h"
#include "core/image/image.h"

namespace etak {

/// Both textures of a material in memory: RGBA, of one size.
template <class Value>
struct PairOf {
  Pixels<Value> diffuse_alpha, specular_gloss;
  Pixels<Value>& of(Texture texture) {
    return texture == Texture::diffuse_alpha ? diffuse_alpha : specular_gloss;
  }
  const Pixels<Value>& of(Texture texture) const {
    return texture == Texture::diffuse_alpha ? diffuse_alpha : specular_gloss;
  }
};
using MaterialPair = PairOf<std::uint8_t>;
/// Both textures of a material as floats: colours in linear light, alpha and gloss as they are; nothing is clamped.
using FloatPair = PairOf<float>;

}  // namespace etak
