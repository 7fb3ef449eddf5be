// SPDX-License-Identifier: Apache-2.0
#include "core/material/library.h"

#include <algorithm>
#include <filesystem>

#include "core/base/edit_distance.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/material/blob.h"
#include "core/material/json.h"

// The bytes of encode_library(materials/**.json), put into the program by library_blob.S.
extern "C" const char etak_library_begin[];
extern "C" const char etak_library_end[];

namespace etak {
namespace {

namespace fs = std::filesystem;

std::string_view builtin_blob() {
  return {etak_library_begin, static_cast<std::size_t>(etak_library_end - etak_library_begin)};
}

// Names are compared without case, spaces, '-' and '_'.
std::string folded(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c == ' ' || c == '-' || c == '_') continue;
    out.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
  }
  return out;
}

std::vector<std::string> keys_of(const std::string& id, const std::string& name,
                                 const std::vector<std::string>& aliases) {
  std::vector<std::string> keys{folded(id), folded(name)};
  for (const auto& alias : aliases) keys.push_back(folded(alias));
  return keys;
}

std::vector<std::string> json_files(const std::string& folder) {
  std::error_code status;
  std::vector<std::string> files;
  fs::recursive_directory_iterator it(folder, status);
  if (status) throw Error::at(folder, "cannot be opened: " + status.message(), "a folder of material files");
  for (const fs::recursive_directory_iterator end; it != end; it.increment(status)) {
    if (status) throw Error::at(folder, "cannot be read: " + status.message());
    if (it->path().extension() == ".json" && it->is_regular_file(status))
      files.push_back(it->path().string());
  }
  if (files.empty()) throw Error::at(folder, "no *.json", "material files");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

MaterialLibrary MaterialLibrary::builtin() {
  MaterialLibrary library;
  for (BlobEntry& e : decode_index(builtin_blob())) {
    Entry entry;
    entry.keys = keys_of(e.id, e.name, e.aliases);
    entry.id = e.id;
    entry.name = std::move(e.name);
    entry.aliases = std::move(e.aliases);
    entry.blob_offset = e.offset;
    library.ids_.push_back(std::move(e.id));
    library.entries_.push_back(std::move(entry));
  }
  return library;
}

void MaterialLibrary::insert(Entry entry) {
  const auto place = std::lower_bound(ids_.begin(), ids_.end(), entry.id);
  const auto index = place - ids_.begin();
  if (place != ids_.end() && *place == entry.id) {
    entries_[static_cast<std::size_t>(index)] = std::move(entry);
    return;
  }
  ids_.insert(place, entry.id);
  entries_.insert(entries_.begin() + index, std::move(entry));
}

void MaterialLibrary::add_folder(const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> seen;  // id, file
  for (const std::string& file : json_files(folder)) {
    Material material = parse_material(read_file(file), file);
    const auto twin =
        std::find_if(seen.begin(), seen.end(), [&](const auto& s) { return s.first == material.id; });
    if (twin != seen.end())
      throw Error::at(file, "id \"" + material.id + "\" again", "an id not used by " + twin->second);
    seen.emplace_back(material.id, file);
    add(std::move(material));
  }
}

void MaterialLibrary::add(Material material) {
  Entry entry;
  entry.id = material.id;
  entry.name = material.name;
  entry.aliases = material.aliases;
  entry.keys = keys_of(material.id, material.name, material.aliases);
  entry.material = std::move(material);
  insert(std::move(entry));
}

const MaterialLibrary::Entry* MaterialLibrary::entry(std::string_view name) const {
  const std::string key = folded(name);
  const Entry* by_alias = nullptr;
  for (const Entry& e : entries_) {
    if (e.keys.front() == key) return &e;
    if (!by_alias && std::find(e.keys.begin(), e.keys.end(), key) != e.keys.end()) by_alias = &e;
  }
  return by_alias;
}

std::optional<Material> MaterialLibrary::find(std::string_view name) const {
  const Entry* found = entry(name);
  if (!found) return std::nullopt;
  return at(static_cast<std::size_t>(found - entries_.data()));
}

Material MaterialLibrary::at(std::size_t index) const {
  const Entry& e = entries_.at(index);
  if (e.material) return *e.material;
  Material m = decode_material(builtin_blob(), e.blob_offset);
  m.id = e.id;
  m.name = e.name;
  m.aliases = e.aliases;
  return m;
}

std::vector<std::string> MaterialLibrary::nearest(std::string_view name, std::size_t count) const {
  const std::string key = folded(name);
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const Entry& e : entries_) {
    std::size_t best = std::string::npos;
    for (const auto& own : e.keys) best = std::min(best, edit_distance(key, own));
    ranked.emplace_back(best, e.id);
  }
  std::sort(ranked.begin(), ranked.end());
  ranked.resize(std::min(count, ranked.size()));
  std::vector<std::string> out;
  for (auto& [distance, id] : ranked) out.push_back(std::move(id));
  return out;
}

}  // namespace etak
