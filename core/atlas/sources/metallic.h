// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/sources/plane.h"

namespace etak {

struct PackInput;

/// Makes both textures of a material from its base colour (color[0] with alpha in grey[0]), its metalness and its gloss
/// (grey[1]): metallic_channel() for each texel. color[1] is emptied.
void set_metallic(const PlaneSource& metal, PackInput& in);

}  // namespace etak
