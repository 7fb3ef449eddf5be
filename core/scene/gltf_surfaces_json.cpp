// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf_surfaces.h"

#include <string_view>

#include "core/base/json/node_json.h"
#include "core/exchange/surfaces/models.h"
#include "core/scene/gltf_json.h"

namespace etak {
namespace {

constexpr std::string_view glossiness = "KHR_materials_pbrSpecularGlossiness";

// The texture that multiplies a factor; empty: there is none.
std::string texture_of_factor(std::string_view factor) {
  constexpr std::pair<std::string_view, std::string_view> others[] = {
      {"metallicFactor", "metallicRoughnessTexture"},
      {"roughnessFactor", "metallicRoughnessTexture"},
      {"specularFactor", "specularGlossinessTexture"},
      {"glossinessFactor", "specularGlossinessTexture"},
      {"iridescenceThicknessMaximum", "iridescenceThicknessTexture"}};
  for (const auto& [name, texture] : others)
    if (name == factor) return std::string(texture);
  constexpr std::string_view end = "Factor";
  if (!factor.ends_with(end)) return {};
  return std::string(factor.substr(0, factor.size() - end.size())) + "Texture";
}

// Adds the members of an object under `prefix`; of an extension only those that are known.
void add_members(const JsonNode& node, const std::string& prefix, DocumentSurface& out) {
  for (const auto& [key, value] : node.value.items()) {
    if (key == "extensions" || key == "extras") continue;
    SurfaceInput input{prefix + key, node.pointer + '/' + key, {}};
    const std::string texture = texture_of_factor(key);
    const bool textured = (!texture.empty() && node.has(texture)) ||
                          (key == "specularFactor" && !prefix.empty() && node.has("specularTexture"));
    if (value.is_number() && !textured) input.values = {value.get<double>()};
    if (value.is_array() && !textured)
      for (const Json& each : value)
        if (each.is_number()) input.values.push_back(each.get<double>());
    // A fourth number is the opacity, which the scene's reader has checked.
    if (input.values.size() == 4) input.values.pop_back();
    if (prefix.empty() || model_input(out.model, input.name) != nullptr)
      out.inputs.push_back(std::move(input));
  }
}

}  // namespace

std::vector<DocumentSurface> surfaces_of_gltf(const GltfScene& scene) {
  std::vector<DocumentSurface> out;
  if (!scene.json || scene.materials.empty()) return out;
  const JsonDocument root(Json::parse(*scene.json));
  const JsonNode materials = JsonNode{root, scene.path, ""}.at("materials");
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const JsonNode node = materials.at(i);
    DocumentSurface& surface =
        out.emplace_back(DocumentSurface{scene.materials[i].name, "gltf", node.pointer});
    surface.looked_at = scene.material_used[i];
    if (scene.materials[i].unlit) continue;
    add_members(node, "", surface);
    const Json* const other = extension(node.value, glossiness);
    if (node.has("pbrMetallicRoughness") && other == nullptr)
      add_members(node.at("pbrMetallicRoughness"), "", surface);
    if (!node.has("extensions")) continue;
    const JsonNode extensions = node.at("extensions");
    for (const auto& [name, value] : extensions.value.items())
      if (value.is_object()) add_members(extensions.at(name), name == glossiness ? "" : name + ".", surface);
  }
  return out;
}

}  // namespace etak
