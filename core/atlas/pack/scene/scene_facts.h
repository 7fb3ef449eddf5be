// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/atlas/leave_out.h"
#include "core/color/gloss.h"
#include "core/image/material_pair.h"
#include "core/scene/gltf.h"

namespace etak {

/// Puts into `facts` which channels of a material are constant, and the hashes by which equal materials are
/// found. Of floats, a channel varies where its floats differ, even if their codes are equal.
///   used     1 per texel in use, which alone count for the ranges; null for all
///   opaque   alpha plays no part
template <class Value>
void look_at(const PairOf<Value>& pair, const std::uint8_t* used, bool opaque, MaterialFacts& facts);

/// What a material is where it has no texture: its own factors where it never had one, else the codes of
/// `facts`. Returns whether its metal-rough form says the same as diffuse and F0, up to the rounding of codes.
bool scene_constants(const MaterialFacts& facts, const GltfMaterial& m, GlossForm gloss, AtlasMaterial& to);

}  // namespace etak
