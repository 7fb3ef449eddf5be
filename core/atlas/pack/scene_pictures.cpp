// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/scene_pictures.h"

#include <algorithm>
#include <cstdint>
#include <functional>

#include "core/color/srgb.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

// Texel `out` of a picture, of the texels `a` and `b` of a page's two textures.
using TexelMap = std::function<void(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out)>;

// A texture that the page does not have reads as 0, 0, 0, 255.
void write_mapped(OutputFolder& folder, const std::string& name, const PagePixels& pixels, int channels,
                  const PngOptions& png, const TexelMap& map) {
  const PixelsView8 a = pixels.view(Texture::diffuse_alpha), b = pixels.view(Texture::specular_gloss);
  const PixelsView8& some = a.data != nullptr ? a : b;
  constexpr std::uint8_t none[4] = {0, 0, 0, 255};
  Image8 out(some.width, some.height, channels);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      map(a.data != nullptr ? a.at(x, y) : none, b.data != nullptr ? b.at(x, y) : none, out.at(x, y).data());
  folder.write(name, [&](const std::function<void(std::string_view)>& sink) { write_png(out, png, sink); });
}

}  // namespace

std::string scene_picture(int page, const std::string& what) {
  return "page" + std::to_string(page) + "_" + what + ".png";
}

std::vector<std::string> write_scene_pictures(OutputFolder& folder, int page, const PagePixels& pixels,
                                              std::span<const GltfForm> forms, GlossForm gloss,
                                              const PngOptions& png) {
  std::vector<std::string> names;
  const auto has = [&](GltfForm form) { return std::find(forms.begin(), forms.end(), form) != forms.end(); };
  const auto roughness = roughness_codes(gloss);
  const bool b = pixels.view(Texture::specular_gloss).data != nullptr;
  const auto write = [&](const char* what, int channels, const TexelMap& map) {
    write_mapped(folder, names.emplace_back(scene_picture(page, what)), pixels, channels, png, map);
  };
  if (b && has(GltfForm::specular_ior))
    write("roughness", 3, [&](const std::uint8_t*, const std::uint8_t* sg, std::uint8_t* out) {
      out[0] = 255, out[1] = roughness[sg[3]], out[2] = 0;
    });
  if (!has(GltfForm::metal_rough)) return names;
  const auto solved = [](const std::uint8_t* da, const std::uint8_t* sg) {
    DiffuseSpecular texel;
    for (std::size_t c = 0; c < 3; ++c)
      texel.diffuse[c] = srgb_decode(da[c] / 255.0), texel.f0[c] = srgb_decode(sg[c] / 255.0);
    return metal_rough_of(texel);
  };
  write("base_color", 4, [&](const std::uint8_t* da, const std::uint8_t* sg, std::uint8_t* out) {
    const MetalRough m = solved(da, sg);
    for (std::size_t c = 0; c < 3; ++c) out[c] = srgb_u8(m.base[c]);
    out[3] = da[3];
  });
  write("metal_rough", 3, [&](const std::uint8_t* da, const std::uint8_t* sg, std::uint8_t* out) {
    const double metallic = std::clamp(solved(da, sg).metallic, 0.0, 1.0);
    out[0] = 255, out[1] = roughness[sg[3]], out[2] = static_cast<std::uint8_t>(255 * metallic + 0.5);
  });
  return names;
}

}  // namespace etak
