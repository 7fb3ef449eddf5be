// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/exchange/content_kind.h"
#include "core/exchange/material_file.h"
#include "core/image/load.h"
#include "core/image/picture_bytes.h"
#include "core/image/picture_endings.h"
#include "core/judge/engine.h"
#include "core/judge/pixels/flat_rows.h"
#include "core/judge/rules.h"
#include "core/scene/gltf.h"
#include "core/validate/files/check_maps.h"
#include "core/validate/files/material_evidence.h"
#include "core/validate/files/metal_rough.h"
#include "core/validate/files/page_parts.h"
#include "core/validate/files/scene_check.h"
#include "core/validate/files/scene_use.h"

namespace etak {

namespace {

const TargetFile* with_role(const CheckTarget& target, std::initializer_list<FileRole> roles) {
  for (const TargetFile& file : target.files)
    if (std::ranges::find(roles, file.role) != roles.end()) return &file;
  return nullptr;
}

std::unique_ptr<RowSource> open_role(const CheckTarget& target, const PictureOpener& opener,
                                     std::initializer_list<FileRole> roles) {
  const TargetFile* file = with_role(target, roles);
  return file == nullptr ? nullptr : opener(*file);
}

// A pair, or F0 alone: read in strips.
void check_pair(const CheckTarget& target, const PictureOpener& opener, const Settings& settings,
                unsigned threads, Evidence& evidence, CheckedFile& file) {
  if (!target.manifest.parts.empty()) {
    const LoadedPictures whole = put_together(target, opener);
    const auto of_material = [&](Needs) { return whole.in_memory().rows(); };
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
    evidence.headers.push_back({set.header(image++), part.label, role_in_set(part.role), {}});
  evidence.metal_rough = !set.is_specular();
  CheckTarget weighed = target;
  if (evidence.metal_rough) weighed.manifest.specular_weighs_diffuse = true;
  std::optional<LoadedPictures> whole;
  const auto open = [&](Needs) {
    if (!whole)
      if (PictureRows rows = set.rows(); rows.b) return rows;
    if (!whole) whole = set.convert();
    return whole->in_memory().rows();
  };
  look_at_pixels(weighed, open, settings, threads, evidence, file);
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
  if (const TargetFile* base = with_role(target, {FileRole::base_color, FileRole::diffuse_alpha});
      base != nullptr && evidence.a)
    for (const PictureEvidence& header : evidence.headers)
      if (header.label == base->label) evidence.a->header.channels = header.header.channels;
}

// Judges every used material on its own, on the texels that triangles read.
void check_scene(const TargetFile& of_scene, const CheckTarget& target, const PictureDoor& door,
                 const Settings& settings, unsigned threads, CheckedFile& file) {
  const GltfScene scene = read_gltf(of_scene.path, GltfOptions{});
  const MaterialUses uses(scene);
  SceneCheck check(uses, of_scene, door);
  const bool wants_pixels = needs_of(target, settings).pixels();
  if (wants_pixels)
    for (const SceneLook& look : check.looks()) {
      LoadedPictures pictures = check.pictures_of(look);
      const auto use = texels_in_use(uses, look.materials, pictures.a.width, pictures.a.height);
      add_look(check.judge(look, std::move(pictures), use, check.labels_of(look), target.manifest, settings,
                           threads),
               file);
    }
  const std::size_t decoded = wants_pixels ? check.textures() : 0;
  file.stats.pictures_decoded += decoded;
  file.stats.pictures_left_out += scene.images.size() - decoded;
  check.judge_headers(target.manifest, settings, file);
}

std::string relabelled(std::string message, const CheckTarget& target) {
  // Readers name the path they were given; reports name the label.
  for (const TargetFile& file : target.files)
    if (!file.path.empty() && file.path != file.label && message.starts_with(file.path))
      return file.label + message.substr(file.path.size());
  return message;
}

}  // namespace

void add_sums(const CheckedFile& one, CheckedFile& file) {
  file.unreadable = file.unreadable || one.unreadable;
  file.plateau_px += one.plateau_px;
  file.transition_px += one.transition_px;
  file.stats.texels += one.stats.texels;
  file.stats.passes += one.stats.passes;
  file.stats.byte_seconds += one.stats.byte_seconds;
  file.stats.region_seconds += one.stats.region_seconds;
  for (const auto& [what, count] : one.counts) {
    const auto same = std::ranges::find(file.counts, what, &std::pair<std::string, std::int64_t>::first);
    if (same == file.counts.end())
      file.counts.emplace_back(what, count);
    else if (what == "gloss_min")
      same->second = std::min(same->second, count);
    else if (what == "gloss_max")
      same->second = std::max(same->second, count);
    else
      same->second += count;
  }
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

void sort_findings(CheckedFile& file) {
  std::stable_sort(file.findings.begin(), file.findings.end(), [](const Finding& a, const Finding& b) {
    return std::tie(a.rule, a.tile, a.pointer) < std::tie(b.rule, b.tile, b.pointer);
  });
}

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
    Finding finding = finding_of(*find_rule("ETK902"), Severity::warning);
    finding.file = file.path;
    finding.message = "not enough memory to check the file";
    file.findings.push_back(std::move(finding));
    file.unreadable = true;
  } catch (const std::exception& error) {
    Finding finding = finding_of(*find_rule("ETK901"), Severity::error);
    finding.file = file.path;
    finding.message = std::string("reading failed: ") + error.what();
    file.findings.push_back(std::move(finding));
    file.unreadable = true;
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
    if (const TargetFile* scene = with_role(target, {FileRole::scene}))
      return check_scene(*scene, target, door, own, threads, file);
    if (const TargetFile* material = with_role(target, {FileRole::material, FileRole::spectrum}))
      return check_material(*material, evidence);
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

CheckedFile joined_tiles(std::vector<CheckedFile> tiles) {
  CheckedFile set;
  set.width = tiles.front().width;
  set.height = tiles.front().height;
  set.target = tiles.front().target;
  set.path = set.target->udim;
  set.is_set = true;
  set.place = tiles.front().place;
  for (CheckedFile& one : tiles) {
    for (Finding& finding : one.findings) {
      if (finding.tile.empty()) finding.tile = one.target->tile;
      set.findings.push_back(std::move(finding));
    }
    set.companions.push_back(one.path);
    std::move(one.companions.begin(), one.companions.end(), std::back_inserter(set.companions));
    std::move(one.roles.begin(), one.roles.end(), std::back_inserter(set.roles));
    set.tiles.push_back(one.target);
    set.stats.pictures_decoded += one.stats.pictures_decoded;
    set.stats.pictures_left_out += one.stats.pictures_left_out;
    set.stats.decode_seconds += one.stats.decode_seconds;
    add_sums(one, set);
  }
  sort_findings(set);
  return set;
}

namespace {

std::optional<FileRole> kind_of_json(std::string_view head) {
  const auto has = [&](std::string_view text) { return head.find(text) != std::string_view::npos; };
  if (has("\"pages\"") && (has("\"rects\"") || has("etak-atlas-layout"))) return FileRole::layout;
  if (has("\"datasets\"") || has("etak-material/")) return FileRole::material;
  return std::nullopt;
}

// The role of input from a pipe by its content, because it has no ending that could tell the role.
std::optional<FileRole> kind_of_content(std::string_view head) {
  switch (content_kind(head)) {
    case ContentKind::gltf:
      return FileRole::scene;
    case ContentKind::json:
      return kind_of_json(head);
    case ContentKind::page:
    case ContentKind::table:
      return FileRole::spectrum;
    case ContentKind::binary:
    case ContentKind::prose:
      break;
  }
  // A picture may look like text as well: Radiance HDR begins with lines of text.
  if (!picture_format(head, "").empty()) return FileRole::specular_gloss;
  return std::nullopt;
}

}  // namespace

std::optional<FileRole> role_of_file(const std::string& path) {
  const std::string ending = lower_case(sys::path_text(std::filesystem::path(path).extension()));
  const std::string_view bare = std::string_view(ending).substr(ending.empty() ? 0 : 1);
  if (bare == radiance_ending ||
      std::find(picture_endings.begin(), picture_endings.end(), bare) != picture_endings.end())
    return FileRole::specular_gloss;
  if (ending == ".gltf" || ending == ".glb") return FileRole::scene;
  const MaterialFileKind kind = material_file_kind(path);
  if (kind == MaterialFileKind::page || (kind == MaterialFileKind::table && !may_be_prose(path)))
    return FileRole::spectrum;
  const bool pipe = is_pipe_input(path);
  if (ending != ".json" && !pipe) return std::nullopt;
  const std::string head = read_head(path, content_head);
  return ending == ".json" ? kind_of_json(head) : kind_of_content(head);
}

std::unique_ptr<RowSource> open_target_file(const TargetFile& file, const PictureDoor& door) {
  return file.bytes ? open_picture(*file.bytes, file.label, door) : open_picture(file.path, door);
}

PicturesInMemory LoadedPictures::in_memory() const {
  return {a.width == 0 ? nullptr : &a, b.width == 0 ? nullptr : &b,
          metallic.width == 0 ? nullptr : &metallic};
}

LoadedPictures load_pictures(const CheckTarget& target, const PictureDoor& door) {
  if (MetalRoughSet::is_set(target)) return MetalRoughSet(target, door).convert();
  LoadedPictures out;
  const auto load = [&](const TargetFile* file, Image8& to) {
    if (file == nullptr) return;
    Image8 codes;
    auto source = open_target_file(*file, door);
    if (source->header().floating)
      source = rows_of(codes = codes_of(load_picture(file->picture(), door), true));
    to = Image8(source->header().width, source->header().height, 4);
    source->read_rows(to.values.data(), 4 * static_cast<std::size_t>(to.width), to.height);
  };
  load(with_role(target, {FileRole::diffuse_alpha}), out.a);
  load(with_role(target, {FileRole::specular_gloss, FileRole::f0_only}), out.b);
  return out;
}

}  // namespace etak
