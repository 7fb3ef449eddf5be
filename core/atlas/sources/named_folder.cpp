// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "core/atlas/sources/sources.h"
#include "core/base/error.h"
#include "core/base/files/links.h"
#include "core/base/files/paths.h"
#include "core/base/setting.h"
#include "core/base/system.h"
#include "core/image/picture_endings.h"
#include "core/names/picture_sets.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// The pictures of a folder, and of the folders in it, as the names of these may be that of a role.
std::vector<std::string> pictures_in(const std::string& folder, std::vector<std::string>& skipped) {
  std::vector<std::string> out;
  const auto list = [&](const std::string& below, auto again) -> void {
    using Kind = sys::FileInfo::Kind;
    const std::string all = sys::path_text(fs::path(folder) / below);
    const auto unread = walk_folder(all, false, [&](const FolderEntry& entry) {
      const std::string name = below + std::string(entry.name);
      if (entry.kind == Kind::folder) {
        if (below.empty() && !name.starts_with('.')) again(name + '/', again);
      } else if (has_picture_ending(name)) {
        if (entry.kind == Kind::file || entry.kind == Kind::link)
          out.push_back(path_beside(folder, name));
        else
          skipped.push_back(entry.path);
      }
    });
    if (unread) throw Error::at(all, "cannot be read: " + reason_of(unread->why), "a folder of pictures");
  };
  list("", list);
  std::ranges::sort(out);
  return out;
}

// Makes the material of one set of pictures.
class FolderMaterial {
 public:
  FolderMaterial(const PictureSet& set, std::span<const NamedPicture> same, const PictureDoor& door)
      : set_(set), same_(same), door_(door) {}

  // Returns what is missing; empty: nothing is, and `material` is whole but for its name.
  std::string make(ManifestMaterial& material, bool& has_gloss) {
    if (!set_.missing.empty()) return set_.missing;
    const NamedPicture* color = nullptr;
    for (const NamedPicture* picture : set_.members) {
      const ImageSource whole{picture->path, "", ""};
      switch (picture->name.role) {
        case FileRole::base_color:
          material.base_color = whole;
          color = picture;
          break;
        case FileRole::diffuse_alpha:
          material.diffuse = whole;
          color = picture;
          break;
        case FileRole::specular_gloss:
        case FileRole::f0_only:
          material.specular = whole;
          break;
        case FileRole::metallic:
          material.metallic = whole;
          break;
        case FileRole::roughness:
          material.roughness = whole;
          break;
        case FileRole::gloss:
          material.gloss = whole;
          break;
        case FileRole::metal_rough:
          add_packed(*picture, material);
          break;
        default:
          break;
      }
    }
    if (!material.base_color && !material.specular) return "no base colour and no specular";
    if (material.specular && !material.gloss && !material.roughness)
      if (const auto& image = std::get<ImageSource>(*material.specular); channels(image.path) == 4)
        material.gloss = ImageSource{image.path, "a", ""};
    if (material.gloss && material.roughness) material.gloss.reset();
    if (!material.gloss && !material.roughness) return "no gloss and no roughness";
    has_gloss = has_gloss || material.gloss.has_value();
    add_beside(color, material);
    return {};
  }

 private:
  int channels(const std::string& path) const { return picture_header(path, door_).channels; }

  // Channels of a packed picture; as glTF packs them where the name does not say it.
  static void add_packed(const NamedPicture& picture, ManifestMaterial& material) {
    const std::string letters = picture.name.channels.empty() ? "-rm-" : picture.name.channels;
    for (std::size_t i = 0; i < letters.size() && i < 4; ++i) {
      const ImageSource channel{picture.path, std::string(1, "rgba"[i]), ""};
      if (letters[i] == 'm') material.metallic = channel;
      if (letters[i] == 'r') material.roughness = channel;
      if (letters[i] == 's') material.gloss = channel;
    }
  }

  // The normal map and opacity, which is a picture of its own or the fourth channel of the colour.
  void add_beside(const NamedPicture* color, ManifestMaterial& material) const {
    for (const NamedPicture& picture : same_) {
      if (picture.name.role == FileRole::normal && material.normal.empty() && picture.as == ListedAs::judged)
        material.normal = picture.path;
      if (picture.name.role == FileRole::opacity && !material.alpha)
        material.alpha = ImageSource{picture.path, "", ""};
    }
    if (!material.alpha && color != nullptr && channels(color->path) == 4)
      material.alpha = ImageSource{color->path, "a", ""};
  }

  const PictureSet& set_;
  std::span<const NamedPicture> same_;
  const PictureDoor& door_;
};

std::string stem_of(const std::string& path) {
  return sys::path_text(fs::path(path).stem());
}

}  // namespace

AtlasManifest manifest_of_names(const std::string& folder, const PictureDoor& door,
                                std::vector<std::string>& skipped, std::vector<std::string>& remarks) {
  const NameReader reader({});
  std::map<std::string, std::vector<NamedPicture>> groups;  // by key
  for (const std::string& path : pictures_in(folder, skipped))
    if (auto picture = picture_named(reader, path)) groups[picture->key].push_back(std::move(*picture));
  AtlasManifest out;
  std::set<std::string> names;
  std::vector<std::string> missing;
  bool has_gloss = false;
  for (auto& [key, same] : groups) {
    std::map<std::array<std::string, 3>, std::string>
        newest;  // versions, by all else that tells colours apart
    for (const PictureSet& set : sets_of(same)) {
      const NamedPicture& first = *set.members.front();
      if (is_map(first.name.role)) continue;
      const ParsedName& name = first.name;
      if (newest.try_emplace({name.resolution, name.format, name.number}, name.version).first->second !=
          name.version)
        continue;
      ManifestMaterial material;
      const std::string what = FolderMaterial(set, same, door).make(material, has_gloss);
      if (!what.empty()) {
        missing.push_back(first.path + ": " + what + ": left out");
        continue;
      }
      material.name = name.set.empty() ? stem_of(first.path) : name.set;
      if (!name.tile.empty()) material.name += '.' + name.tile;
      // Colour variants and sizes of one set share its name.
      if (names.contains(material.name)) material.name = stem_of(first.path);
      for (int copy = 2; !names.insert(material.name).second; ++copy)
        material.name = stem_of(first.path) + '.' + std::to_string(copy);
      material.place = first.path;
      out.materials.push_back(std::move(material));
    }
  }
  if (out.materials.empty())
    throw Error::at(
        folder, missing.empty() ? "no picture's name tells a set with its roles" : missing.front(),
        "names such as wall_basecolor.png with wall_orm.png (etak validate --list-files tells what is understood), or " +
            setting("pattern") + " {name}_{role}.png");
  remarks.insert(remarks.end(), missing.begin(), missing.end());
  // Names of gloss and of smoothness mean what is left of roughness.
  if (has_gloss) out.gloss = GlossForm::one_minus_roughness;
  std::ranges::sort(out.materials, {}, &ManifestMaterial::name);
  return out;
}

}  // namespace etak
