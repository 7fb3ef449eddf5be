// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/color/gloss.h"
#include "core/image/material_pair.h"
#include "core/scene/gltf.h"
#include "core/scene/uv_transform.h"
#include "core/scene/uv_use.h"

namespace etak {

/// The picture of an image of the document: 8-bit codes, or floats, which are fractions of full scale.
template <class Value>
using SceneImages = std::function<const Pixels<Value>&(int image)>;

/// A glTF material as texture pair of its largest texture's size; smaller textures are filtered up
/// bilinearly, colours in linear light. Alpha is full for opaque materials unless `keep_alpha`. Diffuse
/// colours are those that glTF reduces when shading (material_texels.h).
///   Value     std::uint8_t, or float: nothing is clamped
///   clamped   texels whose gloss had to be brought back to 0..1 are added
template <class Value>
PairOf<Value> scene_material_pair(const GltfMaterial& material, const SceneImages<Value>& images,
                                  GlossForm gloss, bool keep_alpha, std::size_t& clamped);

/// The texel of a picture of `source` texels on a side that lies under the centre of texel x of `width`.
constexpr int texel_under(int x, int width, int source) {
  return static_cast<int>((2LL * x + 1) * source / (2LL * width));
}

/// How much of each texel of a material's pair is metal, as codes of one channel. A smaller texture is not
/// filtered: a mask of metal stays one. Empty (0 x 0) for the specular-glossiness model.
///   width, height   of the pair
Image8 scene_metallic(const GltfMaterial& material, const SceneImages<std::uint8_t>& images, int width,
                      int height);

/// Where the texels of one texture of a material lie on another.
struct TextureOnTexture {
  UvMatrix to_map{1, 0, 0, 0, 1, 0};  // from [0,1]^2 over the first texture's picture to UVs of the other
  std::array<Wrap, 2> wrap{Wrap::repeat, Wrap::repeat};  // of the other
};

/// How a normal map lies on the pair whose first texture is `lead`.
///   use       of the pair's texels
///   returns   none where a texel of the pair would stand for several places of the map: another UV set, or
///             periods of the pair that are none of the map's
std::optional<TextureOnTexture> normals_on_pair(const GltfTexture& map, const GltfTexture& lead,
                                                const TexelUse& use);

/// A normal map at a pair's size, with x and y times `scale`. Each texel is the mean of the normals at up to
/// 8 x 8 places in it, not normalised, so that its length tells how far these normals spread. A smaller map
/// repeats.
Image8 scaled_normals(const Image8& map, double scale, int width, int height,
                      const TextureOnTexture& place = {});

}  // namespace etak
