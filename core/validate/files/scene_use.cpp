// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/scene_use.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>

#include "core/base/error.h"

namespace etak {

namespace {

// The distance in texels at which ETK502 looks for visible neighbours.
constexpr int fringe_reach = 2;

// Gives a hidden texel the colour of the nearest visible one within that distance.
void take_color(Image8& picture, const std::vector<std::uint8_t>& use, int x, int y) {
  int nearest = 2 * fringe_reach * fringe_reach + 1;
  const std::uint8_t* from = nullptr;
  for (int v = std::max(0, y - fringe_reach); v <= std::min(picture.height - 1, y + fringe_reach); ++v)
    for (int u = std::max(0, x - fringe_reach); u <= std::min(picture.width - 1, x + fringe_reach); ++u) {
      const int distance = (u - x) * (u - x) + (v - y) * (v - y);
      const bool used = use[static_cast<std::size_t>(v) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(u)] != 0;
      if (!used || distance >= nearest || picture.at(u, v)[3] == 0) continue;
      nearest = distance;
      from = picture.at(u, v).data();
    }
  if (from != nullptr) std::memcpy(picture.at(x, y).data(), from, 3);
}

// Adds the texels that one material reads; false where it is not known that it reads any.
bool add_use(const TexelUse& use, std::vector<std::uint8_t>& texels) {
  if (use.touched == 0) return false;
  if (texels.empty()) texels.resize(use.mask.size());
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] |= use.mask[i];
  return true;
}

// Marks the texels of row y that lie so near to a texel in use that take_color() may find it. Most hidden
// texels lie farther away, and the search around them is saved.
void mark_near(const std::vector<std::uint8_t>& use, int width, int height, int y,
               std::vector<std::uint8_t>& near) {
  const auto columns = static_cast<std::size_t>(width);
  std::vector<std::uint8_t> column(columns + 2 * fringe_reach, 0);
  for (int v = std::max(0, y - fringe_reach); v <= std::min(height - 1, y + fringe_reach); ++v) {
    const std::uint8_t* row = use.data() + static_cast<std::size_t>(v) * columns;
    for (std::size_t x = 0; x < columns; ++x) column[x + fringe_reach] |= row[x];
  }
  near.assign(columns, 0);
  for (std::size_t shift = 0; shift <= 2 * fringe_reach; ++shift)
    for (std::size_t x = 0; x < columns; ++x) near[x] |= column[x + shift];
}

// Everything that decides the pictures of a material: name, normal map, sides and UVs do not.
auto look_of(const GltfMaterial& m) {
  const auto image = [](const std::optional<GltfTexture>& t) { return t ? t->image : -1; };
  return std::tuple(m.base_color, image(m.base_color_texture), m.metallic, m.roughness,
                    image(m.metallic_roughness_texture), m.ior, m.specular, image(m.specular_texture),
                    m.specular_color, image(m.specular_color_texture), m.specular_glossiness, m.diffuse,
                    image(m.diffuse_texture), m.specular_f0, m.glossiness,
                    image(m.specular_glossiness_texture), m.alpha_mode);
}

}  // namespace

MaterialLooks::MaterialLooks(const GltfScene& scene) : groups_(1), group_of_(scene.materials.size(), 0) {
  std::map<decltype(look_of(GltfMaterial{})), std::size_t> groups;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (!scene.material_used[i]) continue;
    const auto [group, is_new] = groups.try_emplace(look_of(scene.materials[i]), groups_.size());
    if (is_new) groups_.emplace_back();
    group_of_[i] = group->second;
    groups_[group->second].push_back(static_cast<int>(i));
  }
}

const std::vector<int>& MaterialLooks::of(int material) const {
  return groups_[group_of_[static_cast<std::size_t>(material)]];
}

std::vector<std::uint8_t> texels_in_use(const MaterialUses& uses, const std::vector<int>& materials,
                                        int width, int height) {
  const GltfScene& scene = uses.scene();
  std::vector<std::uint8_t> out;
  for (const int index : materials) {
    const GltfMaterial& material = scene.materials[static_cast<std::size_t>(index)];
    const GltfTexture* lead = leading_texture(material);
    if (lead == nullptr || !textures_agree(material)) return {};
    try {
      if (!add_use(texel_use(uses, index, *lead, width, height), out)) return {};
    } catch (const Error&) {
      return {};  // some UVs are not finite
    }
  }
  return out;
}

std::vector<std::uint8_t> texels_in_use(std::span<const TexelUse* const> uses) {
  std::vector<std::uint8_t> out;
  for (const TexelUse* use : uses)
    if (use == nullptr || !add_use(*use, out)) return {};
  return out;
}

std::size_t hide_unused(Pictures& pictures, const std::vector<std::uint8_t>& use) {
  if (use.empty()) return 0;
  std::size_t hidden = 0;
  Image8& a = pictures.a;
  std::vector<std::uint8_t> near;
  for (int y = 0; y < a.height; ++y) {
    mark_near(use, a.width, a.height, y, near);
    for (int x = 0; x < a.width; ++x) {
      if (use[static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
              static_cast<std::size_t>(x)] != 0)
        continue;
      if (near[static_cast<std::size_t>(x)] != 0) take_color(a, use, x, y);
      a.at(x, y)[3] = 0;
      ++hidden;
    }
  }
  return hidden;
}

void forget_unused(Evidence& evidence, std::size_t hidden) {
  for (TileEvidence& tile : evidence.tiles) {
    tile.counts.texels -= hidden;
    tile.counts.alpha_zero -= hidden;
  }
}

}  // namespace etak
