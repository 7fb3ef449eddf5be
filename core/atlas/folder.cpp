// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <map>

#include "core/atlas/manifest.h"
#include "core/base/error.h"
#include "core/base/files/links.h"
#include "core/base/files/paths.h"
#include "core/base/setting.h"
#include "core/base/system.h"
#include "core/image/picture_endings.h"
#include "core/names/names.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

constexpr const char* pattern_form = "a pattern with {name} and {role} once each, as {name}_{role}.png";

// The fixed texts around {name} and {role}.
struct Pattern {
  std::string before, between, after;
  bool name_first = true;
};

Pattern parse_pattern(const std::string& text) {
  const std::size_t name = text.find("{name}"), role = text.find("{role}");
  const bool once = name != text.npos && role != text.npos && text.find("{name}", name + 1) == text.npos &&
                    text.find("{role}", role + 1) == text.npos;
  if (!once || text.find('/') != text.npos)
    throw Error::at(setting("pattern"), printable(text, 80), pattern_form);
  constexpr std::size_t size = 6;  // of "{name}" and of "{role}"
  const std::size_t first = std::min(name, role), second = std::max(name, role);
  Pattern out{text.substr(0, first), text.substr(first + size, second - first - size),
              text.substr(second + size), name < role};
  if (out.between.empty())
    throw Error::at(setting("pattern"), printable(text, 80), "a text between {name} and {role}");
  return out;
}

std::optional<TextureSource>* source_of(ManifestMaterial& material, std::string_view role) {
  if (role == "diffuse") return &material.diffuse;
  if (role == "specular") return &material.specular;
  if (role == "gloss") return &material.gloss;
  if (role == "roughness") return &material.roughness;
  if (role == "alpha") return &material.alpha;
  if (role == "basecolor") return &material.base_color;
  if (role == "metallic") return &material.metallic;
  return nullptr;
}

// Name and role of a file, nothing when it does not follow the pattern. The role is what a role can be, so
// that a name may hold the text between.
bool split(const std::string& file, const Pattern& pattern, std::string& name, std::string& role) {
  if (file.size() < pattern.before.size() + pattern.after.size() || !file.starts_with(pattern.before) ||
      !file.ends_with(pattern.after))
    return false;
  const std::string middle =
      file.substr(pattern.before.size(), file.size() - pattern.before.size() - pattern.after.size());
  const std::size_t at = pattern.name_first ? middle.rfind(pattern.between) : middle.find(pattern.between);
  if (at == middle.npos) return false;
  const std::string left = middle.substr(0, at), right = middle.substr(at + pattern.between.size());
  name = pattern.name_first ? left : right;
  role = pattern.name_first ? right : left;
  ManifestMaterial scratch;
  return !name.empty() && (role == "normal" || source_of(scratch, role) != nullptr);
}

}  // namespace

bool all_follow(const std::string& folder, const std::string& pattern_text) {
  const Pattern pattern = parse_pattern(pattern_text);
  const NameReader reader({});
  bool any = false, others = false;
  (void)walk_folder(folder, false, [&](const FolderEntry& entry) {
    const std::string file(entry.name);
    std::string name, role;
    if (split(file, pattern, name, role)) {
      any = true;
    } else if (has_picture_ending(file)) {
      const auto known = reader.read(file);
      others = others || (known && (is_judged(known->role) || is_map(known->role)));
    }
  });
  return any && !others;
}

AtlasManifest manifest_of_folder(const std::string& folder, const std::string& pattern_text,
                                 std::vector<std::string>* skipped) {
  const Pattern pattern = parse_pattern(pattern_text);
  std::map<std::string, ManifestMaterial> found;
  const auto unread = walk_folder(folder, false, [&](const FolderEntry& entry) {
    using Kind = sys::FileInfo::Kind;
    std::string name, role;
    if (!split(std::string(entry.name), pattern, name, role)) return;
    if (entry.kind != Kind::file && entry.kind != Kind::link) {
      if (skipped != nullptr) skipped->push_back(entry.path);
      return;
    }
    const std::string path = path_beside(folder, std::string(entry.name));
    ManifestMaterial& material = found[name];
    material.name = name;
    material.place = sys::path_text(fs::path(folder) / name);
    if (role == "normal")
      material.normal = path;
    else
      *source_of(material, role) = ImageSource{path, "", ""};
  });
  if (unread) throw Error::at(folder, "cannot be read: " + reason_of(unread->why), "a folder of pictures");
  if (found.empty())
    throw Error::at(folder, "no file follows the pattern " + printable(pattern_text, 80), pattern_form);
  AtlasManifest out;
  for (auto& [name, material] : found) {
    if (!material.specular && !material.base_color)
      throw Error::at(material.place, "no picture of the role specular or basecolor", "one of the two");
    if ((material.base_color || material.metallic) && (material.diffuse || material.specular))
      throw Error::at(material.place, "pictures of basecolor or metallic and of diffuse or specular",
                      "one way of the two");
    if (material.metallic && !material.base_color)
      throw Error::at(material.place, "a picture of metallic without one of basecolor", "both");
    if (material.gloss.has_value() == material.roughness.has_value())
      throw Error::at(material.place,
                      material.gloss ? "pictures of gloss and of roughness" : "no picture of gloss",
                      "one of gloss and roughness");
    out.materials.push_back(std::move(material));
  }
  return out;
}

}  // namespace etak
