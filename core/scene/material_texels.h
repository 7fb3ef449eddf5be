// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/color/gloss.h"
#include "core/math/mat3.h"

namespace etak {

// Converts texels between material models. The functions take linear numbers in double; MetalRoughCodes
// does the same for 8-bit codes.
//
// Based on: Khronos Group, glTF 2.0 specification, appendix B, KHR_materials_ior, KHR_materials_specular and
// KHR_materials_pbrSpecularGlossiness; Schueler 2009, "Simplifying the Cook-Torrance model" (gloss).

/// Schueler's two colours.
struct DiffuseSpecular {
  Vec3 diffuse{0, 0, 0}, f0{0.04, 0.04, 0.04};
};

/// What a diffuse colour means to the shader that reads it.
///   reduced_when_shading   the shader multiplies it by (1 - max F0) or by 1 - F, as glTF does (c_diff of
///                          KHR_materials_pbrSpecularGlossiness; the dielectric part of metal-rough)
///   as_it_is               the shader uses it unchanged, as Schueler's does
enum class DiffuseConvention { reduced_when_shading, as_it_is };

/// The texel that looks the same at normal incidence under another convention. Exact, but towards
/// reduced_when_shading the colour may exceed 1 (F0 near 1), and there is none where F0 is 1 and the diffuse colour is not 0: it
/// is returned unchanged then.
DiffuseSpecular converted(const DiffuseSpecular& texel, DiffuseConvention from, DiffuseConvention to);

/// F0 of glTF's dielectric: min(((ior - 1) / (ior + 1))^2 * specular_color, 1) * specular.
///   ior   1 and above, or 0: the extension's way to say F0 scale 1
Vec3 dielectric_f0(double ior, double specular, const Vec3& specular_color);

/// glTF metal-rough to diffuse and F0: diffuse = base (1 - metallic), F0 from dielectric_f0 to base by
/// metallic. The diffuse colour is one that is reduced when shading.
DiffuseSpecular diffuse_specular(const Vec3& base, double metallic, const Vec3& dielectric_f0);

/// The inverse of diffuse_specular() for a dielectric F0 of 0.04 (ior 1.5): `metallic` from the luminances,
/// then the base by least squares. Exact for results of diffuse_specular() with ior 1.5; other colours have
/// no metal-rough form.
///   error   largest difference of a linear channel of diffuse or F0 after going back and forth
struct MetalRough {
  Vec3 base{1, 1, 1};
  double metallic = 0, error = 0;
};
MetalRough metal_rough_of(const DiffuseSpecular& texel);

/// Roughness code (what a glTF roughness texture holds) of a gloss code: 255 * roughness rounded half up.
std::array<std::uint8_t, 256> roughness_codes(GlossForm form);

/// diffuse_specular() for the 8-bit codes of one material's textures; equal to srgb_u8 of the formulas in
/// double.
class MetalRoughCodes {
 public:
  MetalRoughCodes(const Vec3& base_factor, double metallic_factor, const Vec3& dielectric_f0);

  /// Converts one texel.
  ///   base       code of the base colour texture, sRGB, three channels
  ///   metallic   code of the metallic texture, linear
  ///   diffuse    gets three sRGB codes
  ///   f0         gets three sRGB codes
  void convert(const std::uint8_t* base, std::uint8_t metallic, std::uint8_t* diffuse,
               std::uint8_t* f0) const;

 private:
  std::array<std::array<float, 3>, 256> base_;  // linear, under the factor
  std::array<float, 256> metallic_;
  std::array<float, 3> dielectric_f0_;
};

}  // namespace etak
