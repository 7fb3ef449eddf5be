// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/atlas/outputs.h"
#include "core/atlas/texels/page_pixels.h"
#include "core/base/files/output_folder.h"
#include "core/color/gloss.h"
#include "core/pack/scene/scene_maps.h"
#include "core/scene/gltf.h"

namespace etak {

/// Name of a picture of a page that only the scene reads.
///   what   "roughness", "base_color", "metal_rough", "occlusion", "normal" or "emissive"
std::string scene_picture(int page, const std::string& what);

/// Which picture of a page holds occlusion in its red channel: that of metal and roughness, else one of its own. Beside
/// roughness alone it would make three channels of two.
std::string occlusion_picture(const std::vector<GltfForm>& forms);

/// A page, and what the scene's pictures of it are made of.
struct ScenePictureInput {
  int page = 0;
  const PagePixels& pixels;
  const MapPixels& maps;
  const SceneMaps& by_owner;
  const PackDecision& decision;
  const std::vector<std::string>& read;  // names of the files that the scene reads
  GlossForm gloss;                       // of texture B

  bool reads(const std::string& name) const {
    return std::find(read.begin(), read.end(), name) != read.end();
  }
};

/// Adds to `sizes` what those pictures that the scene reads, and the page's two textures where it reads them,
/// would take as PNG files.
void add_scene_picture_sizes(const ScenePictureInput& in, const WriteOptions& options, PictureSizes& sizes);

/// Writes those pictures that the scene reads beside the page's two textures, level 0, as PNG files of as few
/// channels as hold them; where the level is weighed, in the form of fewest bytes (least_png()). Returns the
/// names of the files.
std::set<std::string> write_scene_pictures(OutputFolder& folder, const ScenePictureInput& in,
                                           const WriteOptions& options);

}  // namespace etak
