// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/atlas/page_pixels.h"
#include "core/base/files/output_folder.h"
#include "core/color/gloss.h"
#include "core/image/files/png.h"
#include "core/scene/gltf.h"

namespace etak {

/// Name of a picture of a page that only the scene reads.
///   what   "roughness", "base_color" or "metal_rough"
std::string scene_picture(int page, const std::string& what);

/// Writes the pictures that the scene's forms need beside the page's two textures, level 0, as PNG files.
///   gloss    of texture B
///   returns  the names of the files
std::vector<std::string> write_scene_pictures(OutputFolder& folder, int page, const PagePixels& pixels,
                                              std::span<const GltfForm> forms, GlossForm gloss,
                                              const PngOptions& png);

}  // namespace etak
