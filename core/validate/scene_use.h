// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/gltf.h"
#include "core/validate/evidence.h"
#include "core/validate/files.h"

namespace etak {

/// A material of a scene and those behind it that are in use too and give the same pictures: all but names,
/// normals, sides and UVs are alike.
std::vector<int> materials_of_one_look(const GltfScene& scene, int material);

/// 1 for every texel that the triangles of a scene read with one of the materials, in pictures of width x
/// height; empty where all of them may be read: textures looked up at different places, UVs that nobody
/// understands, numbers instead of textures.
std::vector<std::uint8_t> texels_in_use(const GltfScene& scene, const std::vector<int>& materials, int width,
                                        int height);

/// Hides the texels that are not in use from the rules: alpha 0, and beside visible ones
/// their colour, so that no fringe is seen where nobody looks. Returns how many.
std::size_t hide_unused(LoadedPictures& pictures, const std::vector<std::uint8_t>& use);

/// Takes so many hidden texels out of what was seen: shares are of the texels in use.
void forget_unused(Evidence& evidence, std::size_t hidden);

}  // namespace etak
