// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "core/image/material_pair.h"
#include "core/scene/gltf.h"
#include "core/scene/gltf_convert.h"

namespace etak {

/// What is lost where a material's own textures become diffuse, F0 and gloss, in codes of 8 bits. The largest
/// difference over the texels in use; their rounding to codes apart, but for `behind`.
///   partial   of texels that are partly metal: glTF takes 1 - F of the dielectric from their diffuse light,
///             and of a pair 1 - F of all F0 that they have
///   between   of diffuse and F0, half way between two neighbouring texels and amid four, across the seam of a
///             texture that repeats too: a sampler mixes metal and base colour before the shader makes diffuse
///             and F0 of them, and of a pair diffuse and F0 themselves. With textures of KHR_materials_specular
///             of all that the pair holds, there and at texel centres. Else 0 where the textures differ in size
///   resized   of diffuse, F0, gloss and alpha, at the centres of the texels of textures that are smaller than the
///             pair and were filtered up
///   tinted    of F0 of metal, which vertex colours (COLOR_0) multiply where it comes from base colour
///   behind    more than a code of diffuse light behind F0 near white, which is 1 - F0 of it: there the rounding of
///             F0 counts. Of specular-glossiness whose textures are of one size; else 0
///   sizes     of the textures that differ: "1024 x 1024 and 512 x 512"; empty where all are of one size
struct ConversionCost {
  double partial = 0, between = 0, resized = 0, tinted = 0, behind = 0;
  std::string sizes;

  /// Whether all of it is so little that with the rounding of codes nothing is off by more than one.
  bool is_exact() const { return std::max({partial, between, resized, tinted, behind}) < least_told; }

  static constexpr double least_told = 0.5;  // codes
};

///   pair     of the material, as scene_material_pair() gives it
///   used     a byte for each texel of the pair, 0 for those that nothing reads; null: all are read
///   colors   of all vertices that the material is drawn with
ConversionCost conversion_cost(const GltfMaterial& material, const SceneImages<std::uint8_t>& images,
                               const MaterialPair& pair, GlossForm gloss, const std::uint8_t* used,
                               const VertexColors& colors = {});

/// The sentence that a remark says of a cost, without the material's name. None where the conversion is exact.
std::optional<std::string> sentence_of(const ConversionCost& cost);

}  // namespace etak
