// SPDX-License-Identifier: Apache-2.0
#include "core/scene/image_roles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/scene/gltf_json.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

// The key of a texture in a material, and the word for what it holds.
struct TextureKind {
  std::string_view key, word;
  bool material;
};

// In the order in which roles are told. Other extensions' textures are told by their keys.
constexpr std::array kinds{TextureKind{"baseColorTexture", "base colour", true},
                           TextureKind{"diffuseTexture", "diffuse", true},
                           TextureKind{"specularColorTexture", "F0", true},
                           TextureKind{"specularTexture", "specular", true},
                           TextureKind{"specularGlossinessTexture", "F0 and gloss", true},
                           TextureKind{"normalTexture", "normal", false},
                           TextureKind{"occlusionTexture", "occlusion", false},
                           TextureKind{"metallicRoughnessTexture", "metal and roughness", true},
                           TextureKind{"emissiveTexture", "emissive", false}};

std::size_t order_of(std::string_view key) {
  const auto at =
      std::find_if(kinds.begin(), kinds.end(), [&](const TextureKind& k) { return k.key == key; });
  return static_cast<std::size_t>(at - kinds.begin());
}

std::string role_of(const std::set<std::pair<std::size_t, std::string>>& keys) {
  std::string out;
  for (const auto& [order, key] : keys) {
    const std::string word(order < kinds.size() ? kinds[order].word : std::string_view(key));
    out += (out.empty() ? "" : ", ") + word;
  }
  return out.empty() ? "unused" : out;
}

// Whether the atlas has its own in place of the texture under this key.
bool is_replaced(const std::string& key, const AtlasMaterial& by) {
  if (key == "normalTexture") return by.normal_image.has_value();
  if (key == "occlusionTexture") return by.occlusion_image.has_value();
  if (key == "emissiveTexture") return by.emissive_image.has_value();
  if (by.own_factors && key == "baseColorTexture") return by.base_color_image || by.base_color_in_factors;
  if (by.own_factors && key == "metallicRoughnessTexture")
    return by.metallic_roughness_image || by.metal_rough_in_factors;
  const std::size_t kind = order_of(key);
  return kind < kinds.size() && kinds[kind].material;
}

}  // namespace

std::vector<ImageRole> image_roles(std::string_view json, const std::string& path) {
  const JsonDocument root = parse_json_strictly(json, path, 64, "a glTF document");
  const GltfDocument document{root, path, {}};
  const std::size_t count = document.count("images");
  std::vector<std::set<std::pair<std::size_t, std::string>>> keys(count);
  for (std::size_t i = 0; i < document.count("materials"); ++i)
    each_image_of_material(document, i, [&](const std::string& key, std::size_t image) {
      keys[image].insert({order_of(key), key});
    });
  std::vector<ImageRole> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const JsonNode image = document.element("images", static_cast<int>(i));
    const std::string uri = image.text_or_empty("uri");
    if (!uri.empty() && !uri.starts_with("data:")) out[i].file = file_of_uri(uri, path);
    out[i].role = role_of(keys[i]);
    out[i].material = std::any_of(keys[i].begin(), keys[i].end(), [](const auto& key) {
      return key.first < kinds.size() && kinds[key.first].material;
    });
  }
  return out;
}

std::vector<bool> images_kept(const GltfScene& scene, const GltfOutput& output) {
  const JsonDocument root = parse_json_strictly(*scene.json, scene.path, 64, "a glTF document");
  const GltfDocument document{root, scene.path, {}};
  std::map<int, const AtlasMaterial*> replaced;
  for (const AtlasMaterial& m : output.materials) replaced[m.material] = &m;
  std::vector<bool> out(scene.images.size(), false);
  for (const GltfMaterial& m : scene.materials) {
    if (!scene.material_written[static_cast<std::size_t>(m.index)]) continue;
    const auto found = replaced.find(m.index);
    each_image_of_material(document, static_cast<std::size_t>(m.index),
                           [&](const std::string& key, std::size_t image) {
                             if (found != replaced.end() && is_replaced(key, *found->second)) return;
                             const auto& first = output.stands_for;
                             out[first.empty() ? image : static_cast<std::size_t>(first[image])] = true;
                           });
  }
  return out;
}

}  // namespace etak
