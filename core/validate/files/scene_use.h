// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/material_uses.h"
#include "core/scene/uv_use.h"
#include "core/validate/files/files.h"
#include "core/validate/pixels/evidence.h"

namespace etak {

/// The used materials of a scene by the pictures that they give: those of a group are alike but for names,
/// normals, sides and UVs.
class MaterialLooks {
 public:
  explicit MaterialLooks(const GltfScene& scene);

  /// The group of a used material, rising; none for other materials.
  const std::vector<int>& of(int material) const;

 private:
  std::vector<std::vector<int>> groups_;  // the first has nobody
  std::vector<std::size_t> group_of_;     // by material
};

/// 1 for every texel that the triangles of a scene read with one of the materials, in pictures of width x
/// height; empty where all of them may be read: textures looked up at different places, UVs that nobody
/// understands, numbers instead of textures.
std::vector<std::uint8_t> texels_in_use(const MaterialUses& uses, const std::vector<int>& materials,
                                        int width, int height);
/// The same of uses that are known, of pictures of one size; null: not known.
std::vector<std::uint8_t> texels_in_use(std::span<const TexelUse* const> uses);

/// Hides the texels that are not in use from the rules: alpha 0, and beside visible ones
/// their colour, so that no fringe is seen where nobody looks. Returns how many.
std::size_t hide_unused(LoadedPictures& pictures, const std::vector<std::uint8_t>& use);

/// Takes so many hidden texels out of what was seen: shares are of the texels in use.
void forget_unused(Evidence& evidence, std::size_t hidden);

}  // namespace etak
