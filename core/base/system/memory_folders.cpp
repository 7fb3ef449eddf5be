// SPDX-License-Identifier: Apache-2.0
#ifdef __wasm__

#include <cerrno>
#include <memory>
#include <utility>

#include "core/base/system/memory_nodes.h"

namespace etak::sys {
namespace {

bool make_at(const Place& place) {
  if (!place.folder) return false;
  if (place.folder->entries.contains(place.name)) return refused(EEXIST);
  put(place, made(Kind::folder));
  return true;
}

bool remove_at(const Place& place, bool folder) {
  const Shared node = entry_of(place);
  if (!node) return false;
  if (folder != (node->kind == Kind::folder)) return refused(folder ? ENOTDIR : EISDIR);
  if (!node->entries.empty()) return refused(ENOTEMPTY);
  place.folder->entries.erase(place.name);
  place.folder->written = now();
  return true;
}

bool rename_at(const Place& from, const Place& to, bool replaces) {
  const Shared node = entry_of(from);
  if (!node || !to.folder) return false;
  if (const Shared there = entry_of(to)) {
    if (there == node) return true;
    if (!replaces) return refused(EEXIST);
    if (!remove_at(to, node->kind == Kind::folder)) return false;
  }
  for (Shared above = to.folder; above; above = above->parent.lock())
    if (above == node) return refused(EINVAL);
  from.folder->entries.erase(from.name);
  put(to, node);
  return true;
}

}  // namespace

bool make_folder(const std::string& path) {
  return make_at(place_of(tree().root, path));
}

bool make_folder_in(int folder, const std::string& name, unsigned) {
  return make_at(place_of(node_of(folder), name));
}

bool remove_folder(const std::string& path) {
  return remove_at(place_of(tree().root, path), true);
}

bool remove_in(int folder, const char* name) {
  return remove_at(place_of(node_of(folder), name), false);
}

bool remove_folder_in(int folder, const char* name) {
  return remove_at(place_of(node_of(folder), name), true);
}

bool remove_files_of(int folder) {
  const Shared node = node_of(folder);
  return node &&
         std::erase_if(node->entries, [](const auto& each) { return each.second->kind != Kind::folder; }) > 0;
}

bool rename_in(int from, const std::string& name, int to, const std::string& new_name) {
  return rename_at(place_of(node_of(from), name), place_of(node_of(to), new_name), true);
}

bool rename_new_in(int from, const std::string& name, int to, const std::string& new_name) {
  return rename_at(place_of(node_of(from), name), place_of(node_of(to), new_name), false);
}

bool can_exchange() {
  return false;
}

bool exchange_in(int, const std::string&, int, const std::string&) {
  return refused(ENOSYS);
}

bool link_in(int from, const std::string& name, int to, const std::string& new_name) {
  const Shared node = found_at(node_of(from), name);
  const Place place = place_of(node_of(to), new_name);
  if (!node || !place.folder) return false;
  if (place.folder->entries.contains(place.name)) return refused(EEXIST);
  put(place, node);
  return true;
}

std::filesystem::path working_folder() {
  return "/";
}

std::filesystem::path absolute(const std::filesystem::path& path) {
  return path.empty() ? path : working_folder() / path;
}

std::filesystem::path canonical(const std::filesystem::path& path) {
  if (!found_at(tree().root, path.string())) return {};
  std::filesystem::path out = absolute(path).lexically_normal();
  return out.has_filename() || !out.has_relative_path() ? out : out.parent_path();
}

bool make_link_in(int, const std::string&, const std::string&) {
  return refused(ENOSYS);
}

namespace {

struct Listing {
  std::vector<std::pair<std::string, Kind>> entries;
  std::size_t next = 0;
};

}  // namespace

FolderReader::FolderReader(int folder) : folder_(folder) {
  const Shared node = node_of(folder);
  if (!node || node->kind != Kind::folder) return;
  auto list = std::make_unique<Listing>();
  for (const auto& [name, entry] : node->entries) list->entries.emplace_back(name, entry->kind);
  list_ = list.release();
}

FolderReader::~FolderReader() {
  if (list_ == nullptr) return;
  delete static_cast<Listing*>(list_);
  close_file(folder_);
}

bool FolderReader::next(Entry& out) {
  auto& list = *static_cast<Listing*>(list_);
  errno = 0;
  if (list.next == list.entries.size()) return false;
  const auto& [name, kind] = list.entries[list.next++];
  out = {name.c_str(), kind};
  return true;
}

}  // namespace etak::sys

#endif
