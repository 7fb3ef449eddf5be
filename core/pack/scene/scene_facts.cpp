// SPDX-License-Identifier: Apache-2.0
#include "core/pack/scene/scene_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/base/hash/content_hash.h"
#include "core/color/srgb.h"
#include "core/pack/scene/scene_maps.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/material_texels.h"

namespace etak {

template <class Value>
void look_at(const PairOf<Value>& pair, const std::uint8_t* used, bool opaque, MaterialFacts& facts) {
  const std::size_t texels = pair.diffuse_alpha.pixel_count();
  const auto width = static_cast<std::size_t>(pair.diffuse_alpha.width);
  std::array<Value, channel_count> least, most;
  least.fill(std::numeric_limits<Value>::max());
  most.fill(std::numeric_limits<Value>::lowest());
  facts.range = {};
  ContentHash color, alpha, specular;
  std::vector<Value> rgb, a;
  for (std::size_t row = 0; row < texels; row += width) {
    rgb.clear(), a.clear();
    for (std::size_t i = row; i < row + width; ++i) {
      const Value *da = pair.diffuse_alpha.values.data() + 4 * i,
                  *sg = pair.specular_gloss.values.data() + 4 * i;
      rgb.insert(rgb.end(), {da[0], da[1], da[2]});
      a.push_back(da[3]);
      if (used != nullptr && used[i] == 0) continue;
      for (std::size_t c = 0; c < channel_count; ++c) {
        const Value v = c < 4 ? da[c] : sg[c - 4];
        least[c] = std::min(least[c], v);
        most[c] = std::max(most[c], v);
      }
      facts.range.grey = facts.range.grey && sg[0] == sg[1] && sg[1] == sg[2];
    }
    color.add(rgb.data(), sizeof(Value) * rgb.size());
    alpha.add(a.data(), sizeof(Value) * a.size());
    specular.add(pair.specular_gloss.values.data() + 4 * row, sizeof(Value) * 4 * width);
  }
  if constexpr (std::is_same_v<Value, float>) {
    facts.floats = true;
    for (std::size_t c = 0; c < channel_count; ++c) {
      if (!(least[c] <= most[c])) continue;
      const auto code = [c](float v) { return c % 4 != 3 ? srgb_u8(double{v}) : plain_u8(double{v}); };
      facts.exact[c] = double{least[c]};
      facts.range.least[c] = code(least[c]);
      facts.range.most[c] = code(most[c]);
      if (least[c] != most[c] && facts.range.constant(c)) facts.range.least[c] = 0, facts.range.most[c] = 255;
    }
  } else {
    facts.range.least = least;
    facts.range.most = most;
  }
  facts.color_hash = color.value();
  facts.alpha_hash = opaque ? std::array<std::uint64_t, 2>{} : alpha.value();
  facts.specular_hash = specular.value();
  facts.learned = true;
}

template void look_at(const MaterialPair&, const std::uint8_t*, bool, MaterialFacts&);
template void look_at(const FloatPair&, const std::uint8_t*, bool, MaterialFacts&);

OwnMetalRough own_metal_rough(const GltfMaterial& m, const SceneImages<std::uint8_t>& images,
                              const Image8& pair, const std::uint8_t* used) {
  std::size_t first = 0;
  while (used != nullptr && used[first] == 0) ++first;
  const auto width = static_cast<std::size_t>(pair.width);
  const int x = static_cast<int>(first % width), y = static_cast<int>(first / width);
  const auto codes = [&](const std::optional<GltfTexture>& texture) {
    if (!texture) return std::array<std::uint8_t, 4>{255, 255, 255, 255};
    const Image8& image = images(texture->image);
    return four_channels(
        image.at(texel_under(x, pair.width, image.width), texel_under(y, pair.height, image.height)).data(),
        static_cast<std::size_t>(image.channels), std::uint8_t{255});
  };
  OwnMetalRough out;
  const auto base = codes(m.base_color_texture);
  for (std::size_t c = 0; c < 3; ++c) out.base[c] = m.base_color[c] * srgb_decode(base[c] / 255.0);
  out.metallic = m.metallic * codes(m.metallic_roughness_texture)[2] / 255.0;
  return out;
}

bool scene_constants(const MaterialFacts& facts, const GltfMaterial& m, GlossForm gloss,
                     const std::optional<OwnMetalRough>& own, AtlasMaterial& to) {
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
    // F0 of a plain dielectric is known better than its code says.
    if (!m.specular_glossiness && !m.specular_texture && !m.specular_color_texture) {
      const Vec3 f0 =
          dielectric_f0(m.ior, m.specular, {m.specular_color[0], m.specular_color[1], m.specular_color[2]});
      const auto is_code = [&](std::size_t c) { return srgb_u8(f0[c]) == code[specular_channel + c]; };
      if (is_code(0) && is_code(1) && is_code(2)) to.specular = {f0[0], f0[1], f0[2]};
    }
    // So is F0 that has no texture: of an F0 near 1 its code would double what is left of diffuse light.
    if (m.specular_glossiness && !m.specular_glossiness_texture) to.specular = m.specular_f0;
    to.diffuse[3] = code[alpha_channel] / 255.0;
    to.roughness = converted_gloss(code[gloss_channel] / 255.0, gloss, GlossForm::roughness);
  }
  DiffuseSpecular texel;
  for (std::size_t c = 0; c < 3; ++c) texel.diffuse[c] = to.diffuse[c], texel.f0[c] = to.specular[c];
  const MetalRough solved = metal_rough_of(texel);
  to.base_color = {solved.base[0], solved.base[1], solved.base[2], to.diffuse[3]};
  to.metallic = solved.metallic;
  if (own) {
    std::copy(own->base.begin(), own->base.end(), to.base_color.begin());
    to.metallic = own->metallic;
  }
  const DiffuseSpecular back = diffuse_specular({to.base_color[0], to.base_color[1], to.base_color[2]},
                                                to.metallic, {0.04, 0.04, 0.04});
  const auto agree = [](double a, double b) { return std::abs(srgb_encode(a) - srgb_encode(b)) * 255 < 0.6; };
  for (std::size_t c = 0; c < 3; ++c)
    if (!agree(back.diffuse[c], texel.diffuse[c]) || !agree(back.f0[c], texel.f0[c])) return false;
  return true;
}

}  // namespace etak
