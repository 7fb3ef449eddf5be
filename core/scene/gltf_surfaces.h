// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/exchange/surfaces/document.h"
#include "core/scene/gltf.h"

namespace etak {

/// The materials of a scene as surfaces of the model "gltf": the factors of the core material, and those of the Khronos
/// extensions under "EXTENSION.factor"; a factor that a texture multiplies has no value. One for each element of
/// scene.materials. Members of extensions that models.h does not know are left out.
///   looked_at   of materials that triangles show, whose colours are also judged as pictures
std::vector<DocumentSurface> surfaces_of_gltf(const GltfScene& scene);

}  // namespace etak
