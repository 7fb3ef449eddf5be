// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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
/// "specular-ior", which was "metal-rough" until it got the name that packing has for it, or "specular-glossiness".
std::optional<GltfMaterialForm> gltf_material_form_named(std::string_view text);
inline constexpr std::string_view gltf_form_renamed =
    "metal-rough: is now called specular-ior, as in etak pack";

enum class GltfContainer {
  gltf,  // JSON with the buffer inside, as a data URI
  glb    // binary
};

/// Pictures in place of numbers of a surface, as bytes of PNG files. Where one is empty, the number holds.
///   base_color           sRGB, red, green, blue, and opacity where alpha_mode says so: what the shader
///                        multiplies by 1 - max F0, as it does with every diffuse colour of a dielectric
///   metallic_roughness   linear: green is the roughness, blue is full
///   specular_color       sRGB: F0 itself. The material is then a dielectric whose index has the F0 1
///                        (KHR_materials_ior 0)
///   emissive             sRGB, which the surface's emission multiplies
///   occlusion            linear: red is the share of light from all around that reaches the surface
///   opacity_alone        base_color is white, and the number of the colour holds
///   alpha_mode           "OPAQUE", "MASK" or "BLEND", where the opacity stands in base_color; else empty
///   alpha_cutoff         of the mode "MASK"
struct GltfPictures {
  std::string base_color, metallic_roughness, specular_color;
  bool opacity_alone = false;
  std::string alpha_mode;
  double alpha_cutoff = 0.5;
  std::string emissive{}, occlusion{}, normal{};
  std::array<double, 2> scale{1, 1};  // how often all of them repeat over u and v
  bool empty() const {
    return base_color.empty() && metallic_roughness.empty() && specular_color.empty() && emissive.empty() &&
           occlusion.empty() && normal.empty();
  }
};

/// A glTF 2.0 document: a row of unit spheres, one per surface, each with its material, so that a viewer
/// shows something. Where F0 came from, the measured values and every change stand in the material's extras.
///   surfaces   valid, linear sRGB (throws Error otherwise)
///   changes    one list per surface
///   pictures   one per surface, or none at all. The document holds them. Throws Error for pictures with the
///              form specular_glossiness
///   returns    the bytes of the file
std::string gltf_document(std::span<const ExportSurface> surfaces, GltfMaterialForm form,
                          GltfContainer container, Fit fit, std::vector<Changes>& changes,
                          std::span<const GltfPictures> pictures = {});

}  // namespace etak
