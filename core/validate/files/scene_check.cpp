// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/scene_check.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "core/image/same_pictures.h"
#include "core/image/texture_bytes.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"
#include "core/judge/rules/surface_check.h"
#include "core/scene/gltf_surfaces.h"
#include "core/scene/uv_use.h"
#include "core/validate/files/check_maps.h"
#include "core/validate/files/picture_looks.h"
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

// The textures of a material with what each holds.
std::vector<std::pair<const GltfTexture*, FileRole>> textures_with_roles(const GltfMaterial& m) {
  const auto [first, second, first_role, second_role] = textures_of(m);
  std::vector<std::pair<const GltfTexture*, FileRole>> out;
  const auto add = [&](const std::optional<GltfTexture>& texture, FileRole role) {
    if (texture) out.emplace_back(&*texture, role);
  };
  add(first, first_role);
  add(second, second_role);
  if (!m.specular_glossiness) add(m.specular_color_texture, FileRole::specular_gloss);
  add(m.normal_texture, FileRole::normal);
  add(m.occlusion_texture, FileRole::occlusion);
  add(m.emissive_texture, FileRole::emissive);
  return out;
}

// Areas of a material's triangles in the world and in UVs of a texture.
struct TriangleAreas {
  double world = 0, uv = 0;
};
TriangleAreas areas_of(const MaterialUses& uses, int material, const GltfTexture& texture) {
  TriangleAreas out;
  const UvMatrix matrix = uv_matrix(texture.transform);
  for (const GltfUse* use : uses.of(material)) {
    if (texture.uv_set > 1 || use->uv[texture.uv_set].size() != use->world_area.size()) continue;
    for (std::size_t i = 0; i < use->world_area.size(); ++i) {
      const auto& corners = use->uv[texture.uv_set][i];
      std::array<Uv, 3> p;
      for (std::size_t c = 0; c < 3; ++c) p[c] = matrix * Uv{corners[c][0], corners[c][1]};
      out.world += double{use->world_area[i]};
      out.uv +=
          std::abs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1])) / 2;
    }
  }
  return out;
}

}  // namespace

std::vector<TextureDensity> SceneCheck::densities() {
  std::vector<TextureDensity> out;
  for (const GltfMaterial& m : uses_.scene().materials) {
    if (!uses_.scene().material_used[static_cast<std::size_t>(m.index)]) continue;
    for (const auto& [texture, role] : textures_with_roles(m)) {
      const TriangleAreas areas = areas_of(uses_, m.index, *texture);
      if (!(areas.world > 0 && areas.uv > 0)) continue;
      const PictureHeader& header = pictures_.header(texture->image);
      out.push_back({m.name, image_label(of_scene_, uses_.scene(), texture->image), role,
                     std::sqrt(areas.uv / areas.world * header.width * header.height)});
    }
  }
  return out;
}

std::vector<PictureLook> SceneCheck::picture_looks(const Settings& settings) {
  const LooksWanted wanted = looks_wanted(settings);
  std::map<int, std::pair<FileRole, std::array<bool, 2>>>
      images;  // with the axes along which they are laid beside themselves
  for (const GltfMaterial& m : uses_.scene().materials) {
    if (!(wanted.wide || wanted.edges) || !uses_.scene().material_used[static_cast<std::size_t>(m.index)])
      continue;
    for (const auto& [texture, role] : textures_with_roles(m)) {
      auto& axes = images.try_emplace(texture->image, role, std::array<bool, 2>{}).first->second.second;
      // How the UVs lie does not depend on the size of the picture.
      constexpr int side = 64;
      if (!wanted.edges || !texel_use(uses_, m.index, *texture, side, side).tiles) continue;
      axes[0] = axes[0] || texture->sampler.wrap_u == Wrap::repeat;
      axes[1] = axes[1] || texture->sampler.wrap_v == Wrap::repeat;
    }
  }
  std::vector<PictureLook> out;
  for (const auto& [image, of] : images) {
    PictureFile file = uses_.scene().images[static_cast<std::size_t>(image)];
    file.label = image_label(of_scene_, uses_.scene(), image);
    out.push_back(look_at_picture(file, of.first, of.second, wanted, door_));
  }
  return out;
}

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
    : uses_(uses),
      of_scene_(of_scene),
      door_(door),
      pictures_(uses.scene().images, door),
      surfaces_(surfaces_of_gltf(uses.scene())) {
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

Pictures SceneCheck::pictures_of(const SceneLook& look) {
  return convert_material(lead(look), pictures_);
}

std::array<std::string, 2> SceneCheck::labels_of(const SceneLook& look) const {
  const auto label_of = [&](const std::optional<GltfTexture>& texture) {
    return texture ? image_label(of_scene_, uses_.scene(), texture->image) : of_scene_.label;
  };
  const JudgedTextures textures = textures_of(lead(look));
  return {label_of(textures.first), label_of(textures.second)};
}

JudgedLook SceneCheck::judge(const SceneLook& look, LookTexels texels, const Manifest& manifest,
                             const Settings& settings, unsigned threads) const {
  auto& [pictures, use, labels] = texels;
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
      part, [&](Needs) { return texels.pictures.rows(); }, settings, threads, evidence, out.file);
  forget_unused(evidence, hidden);
  // The alpha of an opaque material has no effect, so that its picture counts as one without alpha.
  if (evidence.a) evidence.a->header.channels = material.alpha_mode == AlphaMode::opaque || !color ? 3 : 4;
  if (evidence.b && !second) evidence.b->header.channels = evidence.metal_rough ? 3 : 4;
  etak::judge(part, evidence, settings, out.file);
  const bool textured = leading_texture(material) != nullptr;
  // Rules on pictures do not know the material's name. Numbers that are those of the measured material of that name
  // are no mistake.
  if (!textured && !out.file.findings.empty() && std::ranges::all_of(look.materials, [&](int user) {
        return is_as_measured(known_materials(settings), surfaces_[static_cast<std::size_t>(user)]);
      }))
    out.file.findings.clear();
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
  if (has_limit("ETK015", settings) || has_limit("ETK016", settings)) headers.scene = facts_of_scene();
  if (has_limit("ETK016", settings)) headers.scene->densities = densities();
  headers.looks = picture_looks(settings);
  headers.surfaces = surfaces_;
  std::erase_if(headers.surfaces, [](const DocumentSurface& surface) {
    return std::ranges::all_of(surface.inputs, [](const SurfaceInput& each) { return each.values.empty(); });
  });
  etak::judge(textures, headers, settings, file);
}

void add_look(JudgedLook one, CheckedFile& file) {
  std::move(one.file.findings.begin(), one.file.findings.end(), std::back_inserter(file.findings));
  add_sums(one.file, file);
}

}  // namespace etak
