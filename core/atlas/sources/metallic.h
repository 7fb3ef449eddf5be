// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/atlas/sources/plane.h"

namespace etak {

struct PackInput;

/// Makes both textures of a material from its base colour (color[0] with alpha in grey[0]), its metalness and its gloss
/// (grey[1]): metallic_channel() for each texel. color[1] is emptied.
void set_metallic(const PlaneSource& metal, PackInput& in);

/// Turns texels of base colour and alpha, and of three channels of metalness and gloss, into those of both textures.
void convert_metallic(std::uint8_t* base_alpha, std::uint8_t* metal_gloss, std::size_t texels);

}  // namespace etak
