// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/atlas/leave_out.h"
#include "core/color/gloss.h"
#include "core/image/material_pair.h"
#include "core/math/mat3.h"
#include "core/scene/gltf.h"
#include "core/scene/gltf_convert.h"

namespace etak {

/// Puts into `facts` which channels of a material are constant, and the hashes by which equal materials are
/// found. Of floats, a channel varies where its floats differ, even if their codes are equal.
///   used     1 per texel in use, which alone count for the ranges; null for all
///   opaque   alpha plays no part
template <class Value>
void look_at(const PairOf<Value>& pair, const std::uint8_t* used, bool opaque, MaterialFacts& facts);

/// Base colour and metallic of a material, linear.
struct OwnMetalRough {
  Vec3 base{1, 1, 1};
  double metallic = 1;
};

/// What factors and textures say at the first texel in use of the material's pair; textures are not filtered.
///   used   as of look_at()
OwnMetalRough own_metal_rough(const GltfMaterial& m, const SceneImages<std::uint8_t>& images,
                              const Image8& pair, const std::uint8_t* used);

/// What a material is where it has no texture: its own factors where it never had one, else the codes of
/// `facts`. Returns whether its metal-rough form says the same as diffuse and F0, up to the rounding of codes.
///   own   what its metal-rough form is; none: it is solved from diffuse and F0, which say little of dark colours
bool scene_constants(const MaterialFacts& facts, const GltfMaterial& m, GlossForm gloss,
                     const std::optional<OwnMetalRough>& own, AtlasMaterial& to);

}  // namespace etak
