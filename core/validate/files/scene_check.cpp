// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/scene_check.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "core/image/same_pictures.h"
#include "core/image/texture_bytes.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"
#include "core/validate/files/check_maps.h"
#include "core/validate/files/scene_use.h"
#include "core/validate/files/tiles.h"

namespace etak {

namespace {

// The label of a file that a scene names, relative to the same folder as the label of the scene.
std::string label_beside(const TargetFile& scene, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(scene.path).parent_path();
  const std::filesystem::path relative =
      std::filesystem::path(path).lexically_relative(folder.empty() ? "." : folder);
  if (relative.empty()) return path;
  return (std::filesystem::path(scene.label).parent_path() / relative).generic_string();
}

std::string image_label(const TargetFile& of_scene, const GltfScene& scene, int image) {
  const std::string& path = scene.images[static_cast<std::size_t>(image)].path;
  return path.empty() ? of_scene.label + "#/images/" + std::to_string(image) : label_beside(of_scene, path);
}

// The two textures of a material that are judged.
struct JudgedTextures {
  const std::optional<GltfTexture>& first;
  const std::optional<GltfTexture>& second;
  FileRole first_role, second_role;
};
JudgedTextures textures_of(const GltfMaterial& m) {
  if (m.specular_glossiness)
    return {m.diffuse_texture, m.specular_glossiness_texture, FileRole::diffuse_alpha,
            FileRole::specular_gloss};
  return {m.base_color_texture, m.metallic_roughness_texture, FileRole::base_color, FileRole::metal_rough};
}

UvBox in_uv(const PixelBox& box, int width, int height) {
  return {static_cast<double>(box.x) / width, static_cast<double>(box.y) / height,
          static_cast<double>(box.x + box.width) / width, static_cast<double>(box.y + box.height) / height};
}

}  // namespace

namespace {

bool has_scene_budget(const Settings& settings) {
  const Rule& rule = *find_rule("ETK015");
  return severity_of(rule, settings) != Severity::off &&
         std::ranges::any_of(rule.parameters, [&](const RuleParameter& parameter) {
           return parameter_of(rule, parameter.name, settings) > 0;
         });
}

}  // namespace

SceneFacts SceneCheck::facts_of_scene() {
  const GltfScene& scene = uses_.scene();
  const std::vector<int> first = first_of_same_pictures(scene.images, scene.image_used);
  SceneFacts out;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    if (!scene.image_used[i] || first[i] != static_cast<int>(i)) continue;
    ++out.textures;
    out.gpu_bytes += texture_bytes(pictures_.header(first[i]), true);
  }
  return out;
}

SceneCheck::SceneCheck(const MaterialUses& uses, const TargetFile& of_scene, const PictureDoor& door)
    : uses_(uses), of_scene_(of_scene), door_(door), pictures_(uses.scene().images, door) {
  for (const GltfMaterial& material : uses.scene().materials) {
    if (!uses.scene().material_used[static_cast<std::size_t>(material.index)]) continue;
    const auto [first, second, first_role, second_role] = textures_of(material);
    if (first) roles_.emplace(first->image, first_role);
    if (second) roles_.emplace(second->image, second_role);
  }
}

const GltfMaterial& SceneCheck::lead(const SceneLook& look) const {
  return uses_.scene().materials[static_cast<std::size_t>(look.materials.front())];
}

std::vector<SceneLook> SceneCheck::looks() const {
  const GltfScene& scene = uses_.scene();
  const MaterialLooks groups(scene);
  std::vector<SceneLook> out;
  for (const GltfMaterial& material : scene.materials) {
    if (!scene.material_used[static_cast<std::size_t>(material.index)]) continue;
    const std::vector<int>& users = groups.of(material.index);
    if (users.front() != material.index) continue;
    SceneLook& look = out.emplace_back(SceneLook{users, {}});
    for (const int user : users)
      look.names += (look.names.empty() ? "" : ", ") + scene.materials[static_cast<std::size_t>(user)].name;
  }
  return out;
}

LoadedPictures SceneCheck::pictures_of(const SceneLook& look) {
  return convert_material(lead(look), pictures_);
}

std::array<std::string, 2> SceneCheck::labels_of(const SceneLook& look) const {
  const auto label_of = [&](const std::optional<GltfTexture>& texture) {
    return texture ? image_label(of_scene_, uses_.scene(), texture->image) : of_scene_.label;
  };
  const JudgedTextures textures = textures_of(lead(look));
  return {label_of(textures.first), label_of(textures.second)};
}

JudgedLook SceneCheck::judge(const SceneLook& look, LoadedPictures pictures,
                             const std::vector<std::uint8_t>& use, const std::array<std::string, 2>& labels,
                             const Manifest& manifest, const Settings& settings, unsigned threads) const {
  const GltfMaterial& material = lead(look);
  const auto [color, second, first_role, second_role] = textures_of(material);
  CheckTarget part;
  part.label = of_scene_.label;
  part.files = {{first_role, "", labels[0], false}, {second_role, "", labels[1], false}};
  part.manifest = manifest;
  part.manifest.tiles.clear();
  part.manifest.specular_weighs_diffuse = true;
  JudgedLook out;
  Evidence& evidence = out.evidence;
  evidence.metal_rough = !material.specular_glossiness;
  const std::size_t hidden = hide_unused(pictures, use);
  look_at_pixels(
      part, [&](Needs) { return pictures.in_memory().rows(); }, settings, threads, evidence, out.file);
  forget_unused(evidence, hidden);
  // The alpha of an opaque material has no effect, so that its picture counts as one without alpha.
  if (evidence.a) evidence.a->header.channels = material.alpha_mode == AlphaMode::opaque || !color ? 3 : 4;
  if (evidence.b && !second) evidence.b->header.channels = evidence.metal_rough ? 3 : 4;
  etak::judge(part, evidence, settings, out.file);
  const bool textured = leading_texture(material) != nullptr;
  for (Finding& finding : out.file.findings) {
    finding.material = look.names;
    finding.pointer = "/materials/" + std::to_string(material.index);
    if (textured && finding.box) finding.uv = in_uv(*finding.box, pictures.a.width, pictures.a.height);
  }
  return out;
}

void SceneCheck::judge_headers(const Manifest& manifest, const Settings& settings, CheckedFile& file) {
  Evidence headers;
  CheckTarget textures;
  textures.label = of_scene_.label;
  textures.manifest = manifest;
  for (const auto& [image, role] : roles_) {
    const std::string label = image_label(of_scene_, uses_.scene(), image);
    headers.headers.push_back({pictures_.header(image), label, role, {}});
    file.companions.push_back(label);
    file.roles.push_back({label, std::string(name(role))});
  }
  if (needs_of(settings).has(Need::maps))
    headers.maps = normal_maps_of(uses_.scene(), door_,
                                  [this](int image) { return image_label(of_scene_, uses_.scene(), image); });
  for (const MapEvidence& map : headers.maps) {
    file.companions.push_back(map.label);
    file.roles.push_back({map.label, std::string(name(map.role))});
  }
  file.stats.pictures_decoded += headers.maps.size();
  file.stats.pictures_left_out -= std::min(file.stats.pictures_left_out, headers.maps.size());
  if (has_scene_budget(settings)) headers.scene = facts_of_scene();
  etak::judge(textures, headers, settings, file);
}

void add_look(JudgedLook one, CheckedFile& file) {
  std::move(one.file.findings.begin(), one.file.findings.end(), std::back_inserter(file.findings));
  add_sums(one.file, file);
}

}  // namespace etak
