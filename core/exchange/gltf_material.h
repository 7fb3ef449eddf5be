// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/exchange/export_surface.h"

namespace etak {

/// How a glTF document says what a surface is.
enum class GltfMaterialForm {
  metal_rough,  // core material; dielectrics with KHR_materials_ior, and _specular where F0 is coloured;
                // clear bodies with _transmission and _volume
  specular_glossiness  // KHR_materials_pbrSpecularGlossiness (archived) alone
};
enum class GltfContainer {
  gltf,  // JSON with the buffer inside, as a data URI
  glb    // binary
};

/// A glTF 2.0 document: a row of unit spheres, one per surface, each with its material, so that a viewer
/// shows something. Where F0 came from, the measured values and every change stand in the material's extras.
///   surfaces   valid, linear sRGB (throws Error otherwise)
///   changes    one list per surface
///   returns    the bytes of the file
std::string gltf_document(std::span<const ExportSurface> surfaces, GltfMaterialForm form,
                          GltfContainer container, Fit fit, std::vector<Changes>& changes);

}  // namespace etak
