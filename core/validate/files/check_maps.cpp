// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/check_maps.h"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/image/load.h"
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
  if (file.role == FileRole::roughness) return GlossPlace{0, false};
  if (file.role == FileRole::gloss) return GlossPlace{0, true};
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

}  // namespace

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
