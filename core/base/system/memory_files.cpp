// SPDX-License-Identifier: Apache-2.0
#ifdef __wasm__

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include "core/base/system/memory_nodes.h"

namespace etak::sys {
namespace {

bool told(const Shared& node, FileInfo& out) {
  if (!node) return false;
  out = {node->kind, 1, node->number, node->bytes.size(), node->written, node->written, node->mode, 0, 0};
  return true;
}

}  // namespace

bool file_info(const std::string& path, FileInfo& out, bool) {
  return told(found_at(tree().root, path), out);
}

bool file_info(int open, FileInfo& out) {
  return told(node_of(open), out);
}

bool file_info_in(int folder, const char* name, FileInfo& out, bool) {
  return told(found_at(node_of(folder), name), out);
}

int open_file(const std::string& path, Open how) {
  return open_node(found_at(tree().root, path), how == Open::folder || how == Open::unreadable_folder,
                   how == Open::write);
}

int open_in(int folder, const std::string& name, OpenIn how, unsigned mode) {
  const Shared from = node_of(folder);
  if (how == OpenIn::read || how == OpenIn::folder)
    return open_node(found_at(from, name), how == OpenIn::folder, false);
  if (!from) return -1;
  const Place place = place_of(from, name);
  if (!place.folder) return -1;
  Shared node = entry_of(place);
  if (node && how != OpenIn::lock) return failed(EEXIST);
  if (!node) {
    node = made(Kind::file);
    node->mode = mode;
    put(place, node);
  }
  return open_node(std::move(node), false, true);
}

int reopen_folder(int folder) {
  return open_node(node_of(folder), true, false);
}

int duplicate(int open) {
  return open_node(node_of(open), false, false);
}

bool close_file(int open) {
  Opened* const found = opened(open);
  if (found == nullptr) return false;
  unlock(open);
  found->node = nullptr;
  return true;
}

std::ptrdiff_t read_at(int open, void* to, std::size_t count, std::size_t at) {
  const Shared node = node_of(open);
  if (!node) return -1;
  if (node->kind == Kind::folder) return failed(EISDIR);
  const std::string_view left = std::string_view(node->bytes).substr(std::min(at, node->bytes.size()), count);
  if (!left.empty()) std::memcpy(to, left.data(), left.size());
  return static_cast<std::ptrdiff_t>(left.size());
}

std::ptrdiff_t read(int open, void* to, std::size_t count) {
  Opened* const found = opened(open);
  const std::ptrdiff_t got = found == nullptr ? -1 : read_at(open, to, count, found->at);
  if (got > 0) found->at += static_cast<std::size_t>(got);
  return got;
}

std::ptrdiff_t write_at(int open, const void* from, std::size_t count, std::size_t at) {
  const Shared node = node_of(open);
  if (!node) return -1;
  if (node->kind == Kind::folder) return failed(EISDIR);
  if (count == 0) return 0;
  std::string& bytes = node->bytes;
  try {
    if (bytes.capacity() - at < count || bytes.capacity() < at)
      bytes.reserve(std::max(at + count, bytes.capacity() + bytes.capacity() / 2));
    if (bytes.size() < at) bytes.resize(at);
    const std::size_t over = std::min(count, bytes.size() - at);
    bytes.replace(at, over, static_cast<const char*>(from), count);
  } catch (const std::bad_alloc&) {
    return failed(ENOSPC);
  }
  node->given = false;
  node->written = now();
  return static_cast<std::ptrdiff_t>(count);
}

std::ptrdiff_t write(int open, const void* from, std::size_t count) {
  Opened* const found = opened(open);
  if (found == nullptr) return -1;
  // What is written to a stream comes behind all that was written there.
  const std::size_t at = found->node->kind == Kind::pipe ? found->node->bytes.size() : found->at;
  const std::ptrdiff_t wrote = write_at(open, from, count, at);
  if (wrote > 0) found->at = at + count;
  return wrote;
}

bool touch_in(int folder, const char* name) {
  const Shared node = found_at(node_of(folder), name);
  if (node) node->written = now();
  return node != nullptr;
}

bool to_disk(int) {
  return true;
}

void begin_to_disk(int) {}

bool set_mode(int open, unsigned mode) {
  const Shared node = node_of(open);
  if (node) node->mode = mode & 07777;
  return node != nullptr;
}

void set_owner(int, const FileInfo&) {}

unsigned user_mask() {
  return 022;
}

bool try_lock(int open) {
  const Shared node = node_of(open);
  if (!node) return false;
  if (node->locked_by >= 0 && node->locked_by != open) return refused(EWOULDBLOCK);
  node->locked_by = open;
  return true;
}

void unlock(int open) {
  if (const Shared node = node_of(open); node && node->locked_by == open) node->locked_by = -1;
}

bool may_write(const std::string& path) {
  return found_at(tree().root, path) != nullptr;
}

bool may_read(const std::string& path) {
  return found_at(tree().root, path) != nullptr;
}

bool takes_file_name(std::string_view) {
  return true;
}

int memory_file() {
  return descriptor_for(made(Kind::file));
}

int reopen_memory_file(int open) {
  return duplicate(open);
}

void put_in_place_of(int open, int descriptor) {
  if (Opened* const found = opened(descriptor)) *found = {node_of(open)};
}

int wait_for_bytes(int, int) {
  return 1;
}

void let_reading_wait(int) {}

}  // namespace etak::sys

#endif
