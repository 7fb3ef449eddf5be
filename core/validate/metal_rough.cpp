// SPDX-License-Identifier: Apache-2.0
#include "core/validate/metal_rough.h"

#include <algorithm>
#include <cmath>

#include "core/atlas/gltf_convert.h"
#include "core/validate/open_pictures.h"

namespace etak {

ScenePictures::ScenePictures(const std::vector<GltfImage>& images)
    : images_(images), codes_(images.size()), headers_(images.size()) {}

void ScenePictures::load(int image) {
  const auto i = static_cast<std::size_t>(image);
  if (codes_[i].width != 0) return;
  codes_[i] = load_codes(images_[i].path, images_[i].bytes, images_[i].label, headers_[i]);
}

const Image8& ScenePictures::codes(int image) {
  load(image);
  return codes_[static_cast<std::size_t>(image)];
}

const TextureHeader& ScenePictures::header(int image) {
  load(image);
  return headers_[static_cast<std::size_t>(image)];
}

LoadedPictures convert_material(const GltfMaterial& material, ScenePictures& pictures) {
  std::size_t clamped = 0;
  MaterialPair pair = scene_material_pair(
      material, [&](int image) -> const Image8& { return pictures.codes(image); },
      GlossForm::one_minus_roughness, material.alpha_mode != AlphaMode::opaque, clamped);
  LoadedPictures out;
  out.a = std::move(pair.diffuse_alpha);
  out.b = std::move(pair.specular_gloss);
  if (material.specular_glossiness) return out;
  out.metallic =
      Image8(out.a.width, out.a.height, 1,
             static_cast<std::uint8_t>(std::lround(255 * std::clamp(material.metallic, 0.0, 1.0))));
  if (!material.metallic_roughness_texture) return out;
  const Image8& source = pictures.codes(material.metallic_roughness_texture->image);
  const std::size_t channel = source.channels >= 3 ? 2 : 0;
  for (int y = 0; y < out.metallic.height; ++y)
    for (int x = 0; x < out.metallic.width; ++x) {
      // The texel under the centre: a mask of metal is not smoothed.
      const auto u =
          static_cast<int>(static_cast<long long>(2 * x + 1) * source.width / (2 * out.metallic.width));
      const auto v =
          static_cast<int>(static_cast<long long>(2 * y + 1) * source.height / (2 * out.metallic.height));
      const double value = source.at(u, v)[channel] * material.metallic;
      out.metallic.at(x, y)[0] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  return out;
}

MetalRoughSet metal_rough_set(const CheckTarget& target) {
  MetalRoughSet set;
  GltfMaterial& material = set.material;
  material.alpha_mode = AlphaMode::blend;  // the file's alpha is kept
  bool metal_rough = false;
  for (const TargetFile& file : target.files) {
    GltfTexture texture;
    texture.image = static_cast<int>(set.images.size());
    texture.sampler.wrap_u = texture.sampler.wrap_v = Wrap::clamp;
    if (file.role == FileRole::base_color)
      material.base_color_texture = texture;
    else if (file.role == FileRole::metal_rough)
      material.metallic_roughness_texture = texture;
    else
      continue;
    metal_rough = metal_rough || file.role == FileRole::metal_rough;
    set.images.push_back({file.path, "", file.label});
  }
  // A base colour on its own is taken for that of a dielectric.
  if (!metal_rough) material.metallic = 0;
  return set;
}

}  // namespace etak
