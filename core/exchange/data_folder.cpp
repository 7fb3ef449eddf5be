// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/data_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/between_files.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/paths.h"
#include "core/base/parallel.h"
#include "core/base/text/ascii.h"
#include "core/exchange/material_file.h"

namespace etak {
namespace {

using Identity = std::pair<std::uint64_t, std::uint64_t>;
using Kind = sys::FileInfo::Kind;

// What one folder holds; paths whole, folders with '/' at the end.
struct Listing {
  Identity identity{};
  std::vector<std::string> files, linked, folders, linked_folders, skipped;
  bool hides = false;  // it holds something whose name begins with a dot
  std::string failure;
};

enum class EntryKind { file, folder, linked_folder, other };

EntryKind entry_kind(int folder, const sys::FolderReader::Entry& entry) {
  if (entry.kind == Kind::file) return EntryKind::file;
  if (entry.kind == Kind::folder) return EntryKind::folder;
  if (entry.kind && entry.kind != Kind::link) return EntryKind::other;
  sys::FileInfo info;
  // A dangling link counts as a file, so that reading it gives the message.
  if (!sys::file_info_in(folder, entry.name, info, true)) return EntryKind::file;
  if (info.kind == Kind::file) return EntryKind::file;
  if (info.kind != Kind::folder) return EntryKind::other;
  sys::FileInfo link;
  const bool linked = sys::file_info_in(folder, entry.name, link) && link.kind == Kind::link;
  return linked ? EntryKind::linked_folder : EntryKind::folder;
}

Listing read_folder(const std::string& path, bool (*keep)(std::string_view)) {
  Listing out;
  Descriptor opened(sys::open_file(path, sys::Open::folder));
  sys::FolderReader folder(opened.get());
  if (!folder) {
    out.failure = reason_of(errno);
    return out;
  }
  (void)opened.release();
  sys::FileInfo info;
  if (sys::file_info(folder.folder(), info)) out.identity = {info.device, info.number};
  for (sys::FolderReader::Entry entry; folder.next(entry);) {
    BetweenFiles::call();
    if (entry.name[0] == '.') {
      out.hides = true;
      continue;
    }
    const EntryKind kind = entry_kind(folder.folder(), entry);
    if ((kind == EntryKind::file || kind == EntryKind::other) && keep(entry.name))
      (kind == EntryKind::file ? out.files : out.skipped).push_back(path + entry.name);
    if (kind == EntryKind::file && entry.kind != Kind::file && keep(entry.name))
      out.linked.push_back(path + entry.name);
    else if (kind == EntryKind::folder)
      out.folders.push_back(path + entry.name + '/');
    else if (kind == EntryKind::linked_folder)
      out.linked_folders.push_back(path + entry.name + '/');
  }
  // Here, because each folder is read by a thread; what folders hold is then in order for the most part.
  for (std::vector<std::string>* names : {&out.files, &out.linked, &out.folders})
    std::sort(names->begin(), names->end());
  return out;
}

// What a listing has found so far: each folder once, also where several links lead to it.
struct Listed {
  Folder out;
  std::set<Identity> seen = {};
  std::vector<std::string> linked_folders = {};  // that were met and not listed yet
};

// Lists `level` and everything below it, level by level, each level on all threads.
//   through_link   a link leads to these folders
void descend(std::vector<std::string> level, unsigned threads, bool (*keep)(std::string_view),
             bool through_link, Listed& listed) {
  auto& [out, seen, linked] = listed;
  while (!level.empty()) {
    std::vector<Listing> listings(level.size());
    parallel_chunks(level.size(), threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) listings[i] = read_folder(level[i], keep);
    });
    std::vector<std::string> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      Listing& found = listings[i];
      if (!found.failure.empty()) {
        out.unreadable.push_back(Error::at(level[i], "cannot be read: " + found.failure).what());
        continue;
      }
      if (!seen.insert(found.identity).second) continue;
      if (found.hides) out.hiding.push_back(level[i]);
      const std::vector<std::string>& linked_files = through_link ? found.files : found.linked;
      out.linked.insert(out.linked.end(), linked_files.begin(), linked_files.end());
      std::move(found.files.begin(), found.files.end(), std::back_inserter(out.files));
      std::move(found.skipped.begin(), found.skipped.end(), std::back_inserter(out.skipped));
      std::move(found.folders.begin(), found.folders.end(), std::back_inserter(next));
      std::move(found.linked_folders.begin(), found.linked_folders.end(), std::back_inserter(linked));
    }
    level = std::move(next);
  }
}

}  // namespace

bool is_material_file_name(std::string_view path) {
  return material_file_kind(path) != MaterialFileKind::none;
}

Folder list_folder(const std::string& path, unsigned threads, bool (*keep)(std::string_view)) {
  Listed listed;
  Folder& out = listed.out;
  out.root = path.ends_with('/') ? path : path + '/';
  for (const std::string& base : {out.root + "database/", out.root})
    if (is_there(base + "catalog-nk.yml") && is_folder(base + "data")) {
      out.root = base + "data/";
      break;
    }
  descend({out.root}, threads, keep, false, listed);
  if (listed.seen.empty()) throw Error(out.unreadable.front());
  while (!listed.linked_folders.empty()) {
    std::vector<std::string> linked = std::exchange(listed.linked_folders, {});
    std::sort(linked.begin(), linked.end());
    for (const std::string& folder : linked) descend({folder}, threads, keep, true, listed);
  }
  for (std::vector<std::string>* names : {&out.files, &out.linked})
    if (!std::is_sorted(names->begin(), names->end())) std::sort(names->begin(), names->end());
  std::sort(out.skipped.begin(), out.skipped.end());
  return std::move(out);
}

}  // namespace etak
