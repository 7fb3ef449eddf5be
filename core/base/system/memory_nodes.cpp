// SPDX-License-Identifier: Apache-2.0
#ifdef __wasm__

#include "core/base/system/memory_nodes.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

#include "core/base/system/memory_tree.h"

namespace etak::sys {

FileInfo::Time now() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(since);
  return {seconds.count(), std::chrono::nanoseconds(since - seconds).count()};
}

Shared made(Kind kind) {
  static std::uint64_t made_so_far = 0;
  auto out = std::make_shared<Node>();
  out->kind = kind;
  out->number = ++made_so_far;
  out->written = now();
  if (kind == Kind::folder) out->mode = 0755;
  return out;
}

Tree& tree() {
  static Tree all;
  return all;
}

int failed(int why) {
  errno = why;
  return -1;
}

bool refused(int why) {
  errno = why;
  return false;
}

Opened* opened(int descriptor) {
  auto& open = tree().open;
  const auto index = static_cast<std::size_t>(descriptor);
  if (descriptor >= 0 && index < open.size() && open[index].node) return &open[index];
  errno = EBADF;
  return nullptr;
}

int descriptor_for(Shared node) {
  auto& open = tree().open;
  const auto free = std::find_if(open.begin() + 3, open.end(), [](const Opened& each) { return !each.node; });
  const auto index = free - open.begin();
  if (free == open.end()) open.emplace_back();
  open[static_cast<std::size_t>(index)] = {std::move(node)};
  return static_cast<int>(index);
}

Shared found_at(Shared at, std::string_view path) {
  if (path.empty()) errno = ENOENT;
  if (path.empty() || !at) return nullptr;
  if (path.front() == '/') at = tree().root;
  while (!path.empty()) {
    const std::size_t length = std::min(path.find('/'), path.size());
    const std::string_view part = path.substr(0, length);
    if (at->kind != Kind::folder) {
      errno = ENOTDIR;
      return nullptr;
    }
    path.remove_prefix(std::min(length + 1, path.size()));
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      if (Shared above = at->parent.lock()) at = std::move(above);
      continue;
    }
    const auto entry = at->entries.find(part);
    if (entry == at->entries.end()) {
      errno = ENOENT;
      return nullptr;
    }
    at = entry->second;
  }
  return at;
}

Place place_of(const Shared& from, std::string_view path) {
  while (path.size() > 1 && path.ends_with('/')) path.remove_suffix(1);
  const std::size_t slash = path.rfind('/');
  const bool plain = slash == path.npos;
  Place out{plain ? from : found_at(from, path.substr(0, slash + 1)),
            std::string(plain ? path : path.substr(slash + 1))};
  if (!out.folder) return {};
  if (out.folder->kind != Kind::folder || out.name.empty() || out.name == "." || out.name == "..") {
    errno = out.folder->kind == Kind::folder ? EINVAL : ENOTDIR;
    return {};
  }
  return out;
}

Shared node_of(int descriptor) {
  const Opened* const found = opened(descriptor);
  return found == nullptr ? nullptr : found->node;
}

Shared entry_of(const Place& place) {
  if (!place.folder) return nullptr;
  const auto found = place.folder->entries.find(place.name);
  if (found != place.folder->entries.end()) return found->second;
  errno = ENOENT;
  return nullptr;
}

void put(const Place& place, Shared node) {
  node->parent = place.folder;
  place.folder->written = now();
  place.folder->entries.insert_or_assign(place.name, std::move(node));
}

int open_node(Shared node, bool folder, bool writes) {
  if (!node) return -1;
  if (folder && node->kind != Kind::folder) return failed(ENOTDIR);
  if (writes && node->kind == Kind::folder) return failed(EISDIR);
  return descriptor_for(std::move(node));
}

// ---- What the host does

void empty_tree() {
  tree() = {};
}

char* put_file(const std::string& path, std::size_t size) {
  Shared folder = tree().root;
  for (std::size_t slash = path.find('/'); slash != path.npos; slash = path.find('/', slash + 1)) {
    if (slash == 0) continue;
    const std::string above = path.substr(0, slash);
    if (const Shared there = found_at(folder, above);
        there ? there->kind != Kind::folder : !make_folder(above))
      return nullptr;
  }
  const Place place = place_of(folder, path);
  if (!place.folder || place.folder->entries.contains(place.name)) return nullptr;
  const Shared node = made(Kind::file);
  node->given = true;
  node->bytes.resize(size);
  put(place, node);
  return node->bytes.data();
}

char* put_standard_input(std::size_t size) {
  std::string& bytes = tree().open[standard_input].node->bytes;
  bytes.resize(size);
  return bytes.data();
}

const std::string& written_to(int descriptor) {
  return tree().open[static_cast<std::size_t>(descriptor)].node->bytes;
}

std::vector<WrittenFile> written_files() {
  std::vector<WrittenFile> out;
  const auto collect = [&](const auto& self, const Node& folder, const std::string& before) -> void {
    for (const auto& [name, node] : folder.entries) {
      if (node->kind == Kind::folder)
        self(self, *node, before + name + '/');
      else if (!node->given)
        out.push_back({before + name, &node->bytes});
    }
  };
  collect(collect, *tree().root, "");
  return out;
}

}  // namespace etak::sys

#endif
