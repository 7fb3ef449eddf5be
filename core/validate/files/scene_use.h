// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/judge/pixels/evidence.h"
#include "core/scene/material_uses.h"
#include "core/scene/uv_use.h"
#include "core/validate/files/load.h"

namespace etak {

/// Groups of the used materials of a scene that give equal pictures: those of a group differ in name, normal
/// map, sides and UVs only.
class MaterialLooks {
 public:
  explicit MaterialLooks(const GltfScene& scene);

  /// Indices of the materials in the group of a used material, ascending; empty for materials that are not
  /// used.
  const std::vector<int>& of(int material) const;

 private:
  std::vector<std::vector<int>> groups_;  // the first is empty, for materials that are not used
  std::vector<std::size_t> group_of_;     // by material
};

/// 1 for every texel that the triangles of a scene read with one of the materials, in pictures of width x
/// height; empty where all of them may be read: textures that are read at different places, UVs that cannot
/// be evaluated, constants instead of textures.
std::vector<std::uint8_t> texels_in_use(const MaterialUses& uses, const std::vector<int>& materials,
                                        int width, int height);
/// 1 for every texel that one of these uses reads, in pictures of one size; null: a use that is not known.
std::vector<std::uint8_t> texels_in_use(std::span<const TexelUse* const> uses);

/// Hides the texels that are not in use from the rules by an alpha of 0. Beside visible texels they also get
/// the colour of these, so that ETK502 finds no fringe there. Returns the number of hidden texels.
std::size_t hide_unused(Pictures& pictures, const std::vector<std::uint8_t>& use);

/// Subtracts the hidden texels from the counts, so that shares are of the texels in use.
void forget_unused(Evidence& evidence, std::size_t hidden);

}  // namespace etak
