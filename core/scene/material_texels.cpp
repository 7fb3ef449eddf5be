// SPDX-License-Identifier: Apache-2.0
#include "core/scene/material_texels.h"

#include <algorithm>
#include <cmath>

#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/image/linear_tables.h"

namespace etak {
namespace {

double largest(const Vec3& v) {
  return std::max({v[0], v[1], v[2]});
}

}  // namespace

DiffuseSpecular converted(const DiffuseSpecular& texel, DiffuseConvention from, DiffuseConvention to) {
  const double left = 1 - largest(texel.f0);
  if (from == to || left <= 0) return texel;
  const double factor = to == DiffuseConvention::as_it_is ? left : 1 / left;
  DiffuseSpecular out = texel;
  for (double& channel : out.diffuse) channel *= factor;
  return out;
}

Vec3 dielectric_f0(double ior, double specular, const Vec3& specular_color) {
  const double root = (ior - 1) / (ior + 1);
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = std::min(root * root * specular_color[i], 1.0) * specular;
  return out;
}

DiffuseSpecular diffuse_specular(const Vec3& base, double metallic, const Vec3& dielectric_f0) {
  DiffuseSpecular out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.diffuse[i] = base[i] * (1 - metallic);
    out.f0[i] = dielectric_f0[i] * (1 - metallic) + base[i] * metallic;
  }
  return out;
}

MetalRough metal_rough_of(const DiffuseSpecular& texel) {
  constexpr double dielectric = 0.04;
  // With t = 1 - metallic: D = base t and F = 0.04 t + base (1 - t), so 0.04 t^2 - (D + F) t + D = 0.
  const double d = luminance_of(texel.diffuse), sum = d + luminance_of(texel.f0);
  const double root = std::sqrt(std::max(0.0, sum * sum - 4 * dielectric * d));
  // The smaller root, in the form that does not lose digits; without any light, plain black.
  const double t = sum + root > 0 ? std::clamp(2 * d / (sum + root), 0.0, 1.0) : 1;
  MetalRough out;
  // For a dark dielectric another root is smaller. The weights of luminance have a sum of 1 but for rounding.
  out.metallic = std::abs(luminance_of(texel.f0) - dielectric) <= 1e-9 ? 0 : 1 - t;
  const double rest = 1 - out.metallic;
  for (std::size_t i = 0; i < 3; ++i) {
    const double base = (rest * texel.diffuse[i] + out.metallic * (texel.f0[i] - dielectric * rest)) /
                        (rest * rest + out.metallic * out.metallic);
    out.base[i] = std::clamp(base, 0.0, 1.0);
  }
  const DiffuseSpecular back = diffuse_specular(out.base, out.metallic, {dielectric, dielectric, dielectric});
  for (std::size_t i = 0; i < 3; ++i)
    out.error = std::max(
        {out.error, std::abs(back.diffuse[i] - texel.diffuse[i]), std::abs(back.f0[i] - texel.f0[i])});
  return out;
}

std::array<std::uint8_t, 256> roughness_codes(GlossForm form) {
  std::array<std::uint8_t, 256> out;
  for (std::size_t i = 0; i < 256; ++i)
    out[i] = plain_u8(converted_gloss(static_cast<double>(i) / 255, form, GlossForm::roughness));
  return out;
}

MetalRoughCodes::MetalRoughCodes(const Vec3& base_factor, double metallic_factor, const Vec3& dielectric_f0) {
  for (std::size_t i = 0; i < 256; ++i) {
    const double share = static_cast<double>(i) / 255;
    metallic_[i] = static_cast<float>(metallic_factor * share);
    for (std::size_t c = 0; c < 3; ++c) base_[i][c] = static_cast<float>(base_factor[c] * srgb_decode(share));
  }
  for (std::size_t c = 0; c < 3; ++c) dielectric_f0_[c] = static_cast<float>(dielectric_f0[c]);
}

void MetalRoughCodes::convert(const std::uint8_t* base, std::uint8_t metallic, std::uint8_t* diffuse,
                              std::uint8_t* f0) const {
  const LinearTables& tables = linear_tables();
  const float metal = metallic_[metallic], rest = 1 - metal;
  for (std::size_t c = 0; c < 3; ++c) {
    const float linear = base_[base[c]][c];
    diffuse[c] = tables.srgb_code(linear * rest);
    f0[c] = tables.srgb_code(dielectric_f0_[c] * rest + linear * metal);
  }
}

}  // namespace etak
