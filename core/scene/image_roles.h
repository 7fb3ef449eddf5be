// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/gltf.h"

namespace etak {

/// An image of a glTF document and what the document's materials read it as.
///   file    beside the document; empty: its bytes lie inside
///   role    "base colour", "normal", "occlusion, metal and roughness", ...: each kind of texture once, in the
///           order of the specification; "unused" where no material reads it
///   material   whether it is read as colour, metal, roughness, F0 or gloss, which an atlas replaces
struct ImageRole {
  std::string file;
  std::string role;
  bool material = false;

  bool is_unused() const { return role == "unused"; }
};

/// The roles of all images of a document, in its order.
///   json   its text; `path` for messages
/// Throws Error for broken JSON and for names that read_gltf() refuses.
std::vector<ImageRole> image_roles(std::string_view json, const std::string& path);

/// Which images of a scene some material that is reached still reads once `output` has put an atlas in place of
/// its textures; of images of the same bytes the one that stands for them.
std::vector<bool> images_kept(const GltfScene& scene, const GltfOutput& output);

}  // namespace etak
