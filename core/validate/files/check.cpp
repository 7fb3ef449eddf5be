// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/check.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/exchange/surfaces/document.h"
#include "core/judge/engine.h"
#include "core/judge/pixels/flat_rows.h"
#include "core/judge/rules.h"
#include "core/scene/gltf.h"
#include "core/validate/files/check_maps.h"
#include "core/validate/files/material_evidence.h"
#include "core/validate/files/metal_rough.h"
#include "core/validate/files/page_parts.h"
#include "core/validate/files/picture_looks.h"
#include "core/validate/files/scene_check.h"
#include "core/validate/files/scene_use.h"
#include "core/validate/files/tiles.h"

namespace etak {

namespace {

std::unique_ptr<RowSource> open_role(const CheckTarget& target, const PictureOpener& opener,
                                     std::initializer_list<FileRole> roles) {
  const TargetFile* file = target.with_role(roles);
  return file == nullptr ? nullptr : open_page(target, *file, opener);
}

// A pair, or F0 alone: read in strips.
void check_pair(const CheckTarget& target, const PictureOpener& opener, const Settings& settings,
                unsigned threads, Evidence& evidence, CheckedFile& file) {
  if (!target.manifest.parts.empty()) {
    const Pictures whole = put_together(target, opener);
    const auto of_material = [&](Needs) { return whole.rows(); };
    return look_at_pixels(target, of_material, settings, threads, evidence, file);
  }
  const auto open = [&](Needs needs) {
    PictureRows rows;
    if (needs.has(Need::header) || needs.has(Need::bytes_a) || needs.has(Need::floats))
      rows.a = open_role(target, opener, {FileRole::diffuse_alpha});
    if (needs.has(Need::header) || needs.has(Need::bytes_b) || needs.has(Need::floats))
      rows.b = open_role(target, opener, {FileRole::specular_gloss, FileRole::f0_only});
    for (const auto& [source, roles] :
         {std::pair(rows.a.get(), std::vector{FileRole::diffuse_alpha}),
          std::pair(rows.b.get(), std::vector{FileRole::specular_gloss, FileRole::f0_only})})
      if (source != nullptr && evidence.headers.size() < target.files.size())
        for (const TargetFile& part : target.files)
          if (std::ranges::find(roles, part.role) != roles.end())
            evidence.headers.push_back({source->header(), part.label, part.role, {}});
    // Pictures needed for their header only are not decoded.
    if (!needs.has(Need::bytes_a) && !(rows.a && rows.a->header().floating && needs.has(Need::floats)) &&
        rows.a) {
      evidence.a = evidence.headers.front();
      rows.a.reset();
      ++file.stats.pictures_left_out;
    }
    if (!needs.has(Need::bytes_b) && !(rows.b && rows.b->header().floating && needs.has(Need::floats)) &&
        rows.b) {
      evidence.b = evidence.headers.back();
      rows.b.reset();
      ++file.stats.pictures_left_out;
    }
    // A texture that an atlas has left out of its pages, because it is constant in every tile.
    const PictureHeader* page = rows.a ? &rows.a->header() : rows.b ? &rows.b->header() : nullptr;
    const int width = page == nullptr ? 0 : page->width, height = page == nullptr ? 0 : page->height;
    if (needs.has(Need::bytes_a) && !rows.a) rows.a = flat_rows(target, 0, width, height);
    if (needs.has(Need::bytes_b) && !rows.b) rows.b = flat_rows(target, 1, width, height);
    return rows;
  };
  look_at_pixels(target, open, settings, threads, evidence, file);
}

// The role that the header of a file is judged by: diffuse and specular need no fourth channel where gloss
// has a file of its own, and gloss is grey as roughness is.
FileRole role_in_set(FileRole role) {
  if (role == FileRole::diffuse_alpha) return FileRole::base_color;
  if (role == FileRole::specular_gloss) return FileRole::f0_only;
  return role == FileRole::gloss ? FileRole::roughness : role;
}

void check_metal_rough(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                       unsigned threads, Evidence& evidence, CheckedFile& file) {
  MetalRoughSet set(target, door);
  int image = 0;
  for (const TargetFile& part : target.files)
    evidence.headers.push_back(
        {set.header(image++), part.label, role_in_set(part.role), {}, part.channels, {}});
  evidence.metal_rough = !set.is_specular();
  CheckTarget weighed = target;
  if (evidence.metal_rough) weighed.manifest.specular_weighs_diffuse = true;
  std::optional<Pictures> whole;
  const auto open = [&](Needs) {
    if (!whole)
      if (PictureRows rows = set.rows(); rows.b) return rows;
    if (!whole) whole = set.convert();
    return whole->rows();
  };
  look_at_pixels(weighed, open, settings, threads, evidence, file);
  for (std::size_t i = 0; i < target.files.size(); ++i)
    if (const DataCodes* codes = set.data(i)) evidence.headers[i].data = *codes;
  if (const MetalRoughSet::Occlusion* occlusion = set.occlusion()) {
    MapEvidence& map = evidence.maps.emplace_back();
    map.role = FileRole::occlusion;
    map.label = target.files[occlusion->file].label;
    map.width = set.header(static_cast<int>(occlusion->file)).width;
    map.height = set.header(static_cast<int>(occlusion->file)).height;
    map.grey = occlusion->codes;
    map.packed = true;
  }
  // There is an alpha channel where the file of the base colour has one.
  if (const TargetFile* base = target.with_role({FileRole::base_color, FileRole::diffuse_alpha});
      base != nullptr && evidence.a)
    for (const PictureEvidence& header : evidence.headers)
      if (header.label == base->label) evidence.a->header.channels = header.header.channels;
}

// Judges every used material on its own, on the texels that triangles read.
void check_scene(const TargetFile& of_scene, const CheckTarget& target, const PictureDoor& door,
                 const Settings& settings, unsigned threads, CheckedFile& file) {
  GltfOptions parts;
  parts.mesh_door = door.mesh;
  const GltfScene scene = read_gltf(of_scene.path, parts);
  const MaterialUses uses(scene);
  SceneCheck check(uses, of_scene, door);
  const bool wants_pixels = needs_of(target, settings).pixels();
  if (wants_pixels)
    for (const SceneLook& look : check.looks()) {
      Pictures pictures = check.pictures_of(look);
      auto use = texels_in_use(uses, look.materials, pictures.a.width, pictures.a.height);
      add_look(check.judge(look, {std::move(pictures), std::move(use), check.labels_of(look)},
                           target.manifest, settings, threads),
               file);
    }
  const std::size_t decoded = wants_pixels ? check.textures() : 0;
  file.stats.pictures_decoded += decoded;
  file.stats.pictures_left_out += scene.images.size() - decoded;
  check.judge_headers(target.manifest, settings, file);
}

void add_failure(CheckedFile& file, std::string_view rule, Severity severity, const std::string& message) {
  file.findings.push_back(finding_of(*find_rule(rule), severity, file.path, message));
  file.unreadable = true;
}

std::string relabelled(std::string message, const CheckTarget& target) {
  // Readers name the path they were given; reports name the label.
  for (const TargetFile& file : target.files)
    if (!file.path.empty() && file.path != file.label && message.starts_with(file.path))
      return file.label + message.substr(file.path.size());
  return message;
}

void check_map_set(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                   Evidence& evidence, CheckedFile& file) {
  if (!needs_of(target, settings).has(Need::maps)) {
    file.stats.pictures_left_out += target.files.size();
    return;
  }
  evidence.maps = maps_of(target, door);
  file.stats.pictures_decoded += evidence.maps.size();
  if (evidence.maps.empty()) return;
  file.width = evidence.maps.front().width;
  file.height = evidence.maps.front().height;
}

void check_material(const TargetFile& part, Evidence& evidence) {
  const std::string text = read_file(part.path);
  evidence.material = part.role == FileRole::material ? evidence_of_material(text, part.label)
                                                      : evidence_of_spectrum(text, part.path, part.label);
}

}  // namespace

CheckedFile check_by(const CheckTarget& target, const Settings& settings, const EvidenceGatherer& look) {
  const Settings own = settings_for(target, settings);
  CheckedFile file = checked_file_of(target);
  Evidence evidence;
  try {
    look(own, evidence, file);
  } catch (const Error& error) {
    evidence.unreadable.push_back(relabelled(error.what(), target));
    evidence.tiles.clear();
    file.unreadable = true;
  } catch (const std::bad_alloc&) {
    add_failure(file, "ETK902", Severity::warning, "not enough memory to check the file");
  } catch (const std::exception& error) {
    add_failure(file, "ETK901", Severity::error, std::string("reading failed: ") + error.what());
  }
  judge(target, evidence, own, file);
  if (target.files.empty())  // the constants of a layout have no place in a picture
    for (Finding& finding : file.findings) forget_place(finding);
  if (!target.manifest.parts.empty()) put_parts_on_page(target, evidence, file);
  sort_findings(file);
  return file;
}

CheckedFile check(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                  unsigned threads) {
  return check_by(target, settings, [&](const Settings& own, Evidence& evidence, CheckedFile& file) {
    if (const TargetFile* scene = target.with_role({FileRole::scene}))
      return check_scene(*scene, target, door, own, threads, file);
    if (const TargetFile* material = target.with_role({FileRole::material, FileRole::spectrum}))
      return check_material(*material, evidence);
    if (const TargetFile* surfaces = target.with_role({FileRole::surfaces})) {
      evidence.surfaces = surfaces_of_document(surfaces->path, surfaces->label);
      return;
    }
    look_at_pictures(target, door, own, evidence);
    if (severity_of(*find_rule("ETK019"), own) != Severity::off) evidence.losses = losses_of(target, door);
    if (is_map_set(target)) return check_map_set(target, door, own, evidence, file);
    if (MetalRoughSet::is_set(target)) return check_metal_rough(target, door, own, threads, evidence, file);
    const auto open = [&](const TargetFile& part) { return open_target_file(part, door); };
    check_pair(target, open, own, threads, evidence, file);
  });
}

CheckedFile check_opened(const CheckTarget& target, const PictureOpener& open, const Settings& settings,
                         unsigned threads) {
  return check_by(target, settings, [&](const Settings& own, Evidence& evidence, CheckedFile& file) {
    check_pair(target, open, own, threads, evidence, file);
  });
}

}  // namespace etak
