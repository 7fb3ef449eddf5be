// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/scene_facts.h"

#include "core/base/hash/content_hash.h"
#include "core/color/srgb.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/material_texels.h"

namespace etak {

void look_at(const MaterialPair& pair, const TexelUse* use, bool opaque, MaterialFacts& facts) {
  const std::size_t texels = pair.diffuse_alpha.pixel_count();
  const bool masked = use != nullptr && use->touched > 0 && use->mask.size() == texels;
  ContentHash color, alpha, specular;
  std::vector<std::uint8_t> rgb, a;
  const auto width = static_cast<std::size_t>(pair.diffuse_alpha.width);
  for (std::size_t row = 0; row < texels; row += width) {
    rgb.clear(), a.clear();
    for (std::size_t i = row; i < row + width; ++i) {
      const std::uint8_t* t = pair.diffuse_alpha.values.data() + 4 * i;
      rgb.insert(rgb.end(), {t[0], t[1], t[2]});
      a.push_back(t[3]);
      if (masked && use->mask[i] == 0) continue;
      add_texels(facts.range, Texture::diffuse_alpha, t, 1);
      add_texels(facts.range, Texture::specular_gloss, pair.specular_gloss.values.data() + 4 * i, 1);
    }
    color.add(rgb.data(), rgb.size());
    alpha.add(a.data(), a.size());
    specular.add(pair.specular_gloss.values.data() + 4 * row, 4 * width);
  }
  facts.color_hash = color.value();
  facts.alpha_hash = opaque ? std::array<std::uint64_t, 2>{} : alpha.value();
  facts.specular_hash = specular.value();
  facts.learned = true;
}

void scene_constants(const MaterialFacts& facts, const GltfMaterial& m, GlossForm gloss, AtlasMaterial& to) {
  if (replaced_textures(m).empty()) {
    DiffuseSpecular ds;
    if (m.specular_glossiness)
      ds = {{m.diffuse[0], m.diffuse[1], m.diffuse[2]},
            {m.specular_f0[0], m.specular_f0[1], m.specular_f0[2]}};
    else
      ds = diffuse_specular(
          {m.base_color[0], m.base_color[1], m.base_color[2]}, m.metallic,
          dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]}));
    to.diffuse = {ds.diffuse[0], ds.diffuse[1], ds.diffuse[2],
                  m.specular_glossiness ? m.diffuse[3] : m.base_color[3]};
    to.specular = {ds.f0[0], ds.f0[1], ds.f0[2]};
    to.roughness = m.specular_glossiness ? 1 - m.glossiness : m.roughness;
  } else {
    const auto& code = facts.range.most;
    for (std::size_t c = 0; c < 3; ++c) {
      to.diffuse[c] = srgb_decode(code[c] / 255.0);
      to.specular[c] = srgb_decode(code[specular_channel + c] / 255.0);
    }
    to.diffuse[3] = code[alpha_channel] / 255.0;
    to.roughness = converted_gloss(code[gloss_channel] / 255.0, gloss, GlossForm::roughness);
  }
  DiffuseSpecular texel;
  for (std::size_t c = 0; c < 3; ++c) texel.diffuse[c] = to.diffuse[c], texel.f0[c] = to.specular[c];
  const MetalRough solved = metal_rough_of(texel);
  to.base_color = {solved.base[0], solved.base[1], solved.base[2], to.diffuse[3]};
  to.metallic = solved.metallic;
}

}  // namespace etak
