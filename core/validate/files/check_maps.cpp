// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/check_maps.h"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/image/load.h"
#include "core/image/picture_endings.h"
#include "core/maps/map_survey.h"
#include "core/names/names.h"
#include "core/validate/files/load.h"

namespace etak {
namespace {

// A picture beside a map, opened from its top; null where there is none of this size.
struct OpenedBeside {
  std::unique_ptr<RowSource> rows;
  const TargetFile* file = nullptr;
};
//   own   the files are of the map's own check and must be readable; else another check tells that they are not
OpenedBeside open_beside(const std::vector<TargetFile>& files, std::initializer_list<FileRole> roles,
                         const PictureHeader& map, const PictureDoor& door, bool own) {
  for (const FileRole role : roles)
    for (const TargetFile& file : files) {
      if (file.role != role) continue;
      try {
        auto rows = open_target_file(file, door);
        if (rows->header().width == map.width && rows->header().height == map.height)
          return {std::move(rows), &file};
      } catch (const Error&) {
        if (own) throw;
      }
    }
  return {};
}

std::optional<GlossPlace> gloss_place(const TargetFile& file) {
  if (file.role == FileRole::specular_gloss || file.role == FileRole::f0_only) return GlossPlace{3, true};
  if (file.role == FileRole::roughness) return GlossPlace{0, false};
  if (file.role == FileRole::gloss) return GlossPlace{0, true};
  if (file.role != FileRole::metal_rough) return std::nullopt;
  // As glTF packs them where the name does not say it.
  const std::string_view letters = file.channels.empty() ? "-rm-" : std::string_view(file.channels);
  const std::size_t channel = letters.find_first_of("rs");
  if (channel == letters.npos) return std::nullopt;
  return GlossPlace{channel, letters[channel] == 's'};
}

MapEvidence normal_map(const TargetFile& file, const CheckTarget& target, const PictureDoor& door) {
  const auto rows = open_target_file(file, door);
  const OpenedBeside height = open_beside(target.files, {FileRole::height}, rows->header(), door, true);
  OpenedBeside gloss =
      open_beside(target.beside, {FileRole::roughness, FileRole::gloss, FileRole::metal_rough},
                  rows->header(), door, false);
  const auto place = gloss.file == nullptr ? std::nullopt : gloss_place(*gloss.file);
  if (!place) gloss = {};
  MapEvidence out =
      survey_normals(*rows, {height.rows.get(), gloss.rows.get(), place.value_or(GlossPlace{})});
  if (out.gloss) out.gloss->label = gloss.file->label;
  return out;
}

// What a texture has lost against the picture of its name; none: it is not in blocks, or they are not to be compared.
std::optional<BlockLoss> loss_of(const TargetFile& texture, const TargetFile& picture,
                                 const PictureDoor& door) {
  const auto blocks = open_target_file(texture, door), source = open_target_file(picture, door);
  const PictureHeader &held = blocks->header(), &exact = source->header();
  if (held.blocks.empty() || held.width != exact.width || held.height != exact.height ||
      (texture.role == FileRole::normal && held.blocks == "BC3"))
    return std::nullopt;
  std::optional<GlossPlace> gloss = gloss_place(texture);
  if (gloss && gloss->channel == 3 && (held.channels % 2 != 0 || exact.channels % 2 != 0)) gloss.reset();
  BlockLoss out = survey_loss(*blocks, *source, texture.role, gloss);
  out.label = texture.label;
  out.source = picture.label;
  return out;
}

}  // namespace

std::vector<BlockLoss> losses_of(const CheckTarget& target, const PictureDoor& door) {
  std::vector<TargetFile> files = target.files;
  files.insert(files.end(), target.beside.begin(), target.beside.end());
  const auto is_texture = [](const TargetFile& file) { return is_gpu_texture(path_ending(file.path)); };
  std::vector<BlockLoss> out;
  for (std::size_t i = 0; i < target.files.size(); ++i)
    for (std::size_t j = i + 1; j < files.size(); ++j) {
      if (is_texture(files[i]) == is_texture(files[j]) || files[i].role != files[j].role ||
          without_ending(files[i].path) != without_ending(files[j].path))
        continue;
      try {
        auto loss =
            is_texture(files[i]) ? loss_of(files[i], files[j], door) : loss_of(files[j], files[i], door);
        if (loss) out.push_back(*std::move(loss));
      } catch (const Error&) {  // left to the check of the file
      }
    }
  return out;
}

bool is_map_set(const CheckTarget& target) {
  return std::ranges::any_of(target.files, [](const TargetFile& file) { return is_map(file.role); });
}

std::vector<MapEvidence> maps_of(const CheckTarget& target, const PictureDoor& door) {
  std::vector<MapEvidence> out;
  for (const TargetFile& file : target.files) {
    if (file.role == FileRole::height) continue;  // read beside the normal map
    if (file.role == FileRole::normal) {
      out.push_back(normal_map(file, target, door));
    } else {
      const auto rows = open_target_file(file, door);
      const OpenedBeside alpha =
          file.role == FileRole::emissive
              ? open_beside(target.beside, {FileRole::base_color, FileRole::diffuse_alpha}, rows->header(),
                            door, false)
              : OpenedBeside{};
      out.push_back(survey_grey(*rows, file.role, alpha.rows.get()));
    }
    out.back().label = file.label;
    out.back().green = file.green;
    out.back().said_by = "its name";
  }
  return out;
}

std::vector<MapEvidence> normal_maps_of(const GltfScene& scene, const PictureDoor& door,
                                        const std::function<std::string(int image)>& label_of) {
  std::set<int> images;
  for (const GltfMaterial& material : scene.materials)
    if (scene.material_used[static_cast<std::size_t>(material.index)] && material.normal_texture)
      images.insert(material.normal_texture->image);
  std::vector<MapEvidence> out;
  for (const int image : images) {
    const auto rows = open_picture(scene.images[static_cast<std::size_t>(image)], door);
    MapEvidence& map = out.emplace_back(survey_normals(*rows, {}));
    map.label = label_of(image);
    map.green = GreenAxis::opengl;
    map.said_by = "glTF 2.0";
  }
  return out;
}

}  // namespace etak
