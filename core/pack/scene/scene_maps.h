// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_pixels.h"
#include "core/image/picture.h"
#include "core/pack/decision.h"
#include "core/pack/scene/gltf_pack.h"
#include "core/pack/totals.h"
#include "core/scene/gltf.h"

namespace etak {

/// Whether the factors and textures of core glTF's metal-rough form are all that the material's diffuse and F0
/// depend on.
bool is_plain_metal_rough(const GltfMaterial& material);

/// Textures of a scene that are placed on the atlas's pages just as the pair is: they are looked up at the same
/// place, are of its size, and are the same for all materials that share the texels. Images of the document;
/// none: there is no such texture, or it cannot be placed and stays a file of its own.
struct MaterialMaps {
  std::optional<int> base_color, metal_rough, occlusion, normal, emissive;
  // All materials that share the texels and are written are of plain metal-rough form: written so, base colour
  // and metal-rough are the material's own textures, placed or as they are, under its own factors.
  bool exact = false;
};

/// The maps of each material that owns texels, by its index among the inputs.
using SceneMaps = std::map<std::size_t, MaterialMaps>;

/// The textures that can be placed; among images of equal bytes the first stands for all.
SceneMaps scene_maps(const SceneRead& read, const PackDecision& decision, Others others);

/// How textures are weighed.
///   kept   what an image of the document takes as it is
struct MapWeights {
  Others others;
  TextureWeight weight;
  std::function<TextureTotals(int image)> kept;
};

/// The textures of `maps` that are worth their place in a scene of these forms: where they would weigh no less than
/// the textures that they replace, these stay files of their own. `exact` is kept for metal_rough alone,
/// beside which no other form stands.
SceneMaps worthwhile(const SceneMaps& maps, const std::vector<GltfForm>& forms, const PackDecision& decision,
                     const MapWeights& weights);

/// The maps with none of the textures placed that may stay as they are.
SceneMaps none_placed(SceneMaps maps);

/// Level 0 of a page of such textures, gutters included.
///   color      base colour and alpha (A); occlusion, roughness, metal (B)
///   geometry   normal (A); emissive (B)
/// Where no texture is placed A and B are 0, where one of a material's is missing it is 255.
struct MapPixels {
  std::optional<PagePixels> color, geometry;  // none where no texture of it is placed
  std::vector<std::size_t> regions;           // of the page, whose owners have maps
};

MapPixels map_pixels(int page, const SceneMaps& maps, const SceneRead& read, const PackDecision& decision,
                     unsigned threads);

}  // namespace etak
