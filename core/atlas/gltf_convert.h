// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/atlas/manifest.h"
#include "core/atlas/sources.h"
#include "core/scene/gltf.h"

namespace etak {

/// The picture of an image of the document, 8-bit codes.
using SceneImages = std::function<const Image8&(int image)>;

/// A glTF material as texture pair of its largest texture's size; smaller textures are filtered up
/// bilinearly, colours in linear light. Alpha is 255 for opaque materials unless `keep_alpha`. Diffuse
/// colours are those that glTF reduces when shading (material_texels.h).
///   clamped   texels whose gloss had to be brought back to 0..1
MaterialPair scene_material_pair(const GltfMaterial& material, const SceneImages& images, GlossForm gloss,
                                 bool keep_alpha, std::size_t& clamped);

/// The picture of an image of the document as floats: codes as fractions of full scale.
using SceneFloats = std::function<const Image&(int image)>;

/// The same as floats (FloatPair), from pictures of any depth; nothing is clamped.
FloatPair scene_material_floats(const GltfMaterial& material, const SceneFloats& images, GlossForm gloss,
                                bool keep_alpha);

/// A normal map at a pair's size: the nearest normal of each texel, with x and y times `scale`. A larger map
/// loses what lies between, a smaller one repeats.
Image8 scaled_normals(const Image8& map, double scale, int width, int height);

}  // namespace etak
