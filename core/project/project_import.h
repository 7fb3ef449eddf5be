// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/project/project.h"

namespace etak {

/// Whether a file is a material document or a scene by its ending: .mtlx, .usda, .gltf, .glb.
bool holds_surfaces(const std::string& path);

/// The materials of such a file, by the readers of etak validate: F0, diffuse colour and roughness as numbers. A diffuse
/// colour that the document's model reduces by what is reflected is given as etak draws it; a clear body is black.
///   remarks   gets a line for each value that was not taken: that of a picture, of a film, of a metalness between
/// Throws Error for a file that cannot be read, and for one without a material.
std::vector<ProjectMaterial> imported_materials(const std::string& path, std::vector<std::string>& remarks);

}  // namespace etak
