// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/leave_out.h"
#include "core/color/gloss.h"
#include "core/image/material_pair.h"
#include "core/scene/gltf.h"
#include "core/scene/uv_use.h"

namespace etak {

/// What the texels of a scene's material are: ranges of the channels and hashes.
///   use      the texels that triangles touch, which alone count for the ranges; may be null
///   opaque   alpha does not matter
void look_at(const MaterialPair& pair, const TexelUse* use, bool opaque, MaterialFacts& facts);

/// What a material is where it has no texture: its own factors where it never had one, else the codes of `facts`.
void scene_constants(const MaterialFacts& facts, const GltfMaterial& m, GlossForm gloss, AtlasMaterial& to);

}  // namespace etak
