// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/paths.h"

#include <cerrno>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace etak {

using Kind = sys::FileInfo::Kind;

std::optional<Kind> kind_at(const std::string& path, bool follow) {
  sys::FileInfo info;
  return sys::file_info(path, info, follow) ? std::optional(info.kind) : std::nullopt;
}

bool is_there(const std::string& path) {
  return kind_at(path).has_value();
}

bool is_file(const std::string& path) {
  return kind_at(path) == Kind::file;
}

bool is_folder(const std::string& path) {
  return kind_at(path) == Kind::folder;
}

bool is_link(const std::string& path) {
  return kind_at(path, false) == Kind::link;
}

std::filesystem::path plain_path(const std::filesystem::path& path) {
  std::filesystem::path there = sys::absolute(path), rest;
  while (there.has_relative_path() && !is_there(sys::path_text(there))) {
    rest = rest.empty() ? there.filename() : there.filename() / rest;
    there = there.parent_path();
  }
  return rest.empty() ? sys::canonical(there) : (sys::canonical(there) / rest).lexically_normal();
}

std::uint64_t size_of_file(const std::string& path) {
  sys::FileInfo info;
  const bool there = sys::file_info(path, info);
  if (there && info.kind == Kind::file) return info.size;
  const int why = !there ? errno : info.kind == Kind::folder ? EISDIR : ENOTSUP;
  throw Error::at(printable(path, 200), reason_of(why), "a file or folder that can be reached");
}

bool make_folders(const std::filesystem::path& folder, std::vector<std::string>* made) {
  const std::string path = sys::path_text(folder);
  if (is_there(path)) return true;
  if (errno != ENOENT && errno != ENOTDIR) return false;
  const std::filesystem::path above = folder.parent_path();
  if (!above.empty() && above != folder && !make_folders(above, made)) return false;
  if (sys::make_folder(path)) {
    if (made != nullptr) made->push_back(path);
    return true;
  }
  const int why = errno;
  if (why == EEXIST && is_folder(path)) return true;  // another program was faster
  errno = why;
  return false;
}

namespace {

FolderEntry met(const sys::FolderReader& list, const sys::FolderReader::Entry& entry,
                const std::string& folder) {
  FolderEntry out{folder + (folder.ends_with('/') ? "" : "/") + entry.name, entry.name};
  sys::FileInfo info;
  if (entry.kind)
    info.kind = *entry.kind;
  else
    (void)sys::file_info_in(list.folder(), entry.name, info);
  out.linked = info.kind == Kind::link;
  if (out.linked) (void)sys::file_info_in(list.folder(), entry.name, info, true);
  out.kind = info.kind;
  return out;
}

}  // namespace

std::optional<UnreadFolder> walk_folder(const std::string& folder, bool below,
                                        const std::function<void(const FolderEntry&)>& take) {
  std::optional<UnreadFolder> unread;
  std::vector<std::string> left{sys::path_text(folder)};
  while (!left.empty()) {
    const std::string path = std::move(left.back());
    left.pop_back();
    Descriptor opened(sys::open_file(path, sys::Open::folder));
    sys::FolderReader list(opened.get());
    if (list) {
      (void)opened.release();
      for (sys::FolderReader::Entry entry; errno = 0, list.next(entry);) {
        const FolderEntry found = met(list, entry, path);
        if (below && found.kind == Kind::folder && !found.linked) left.push_back(found.path);
        take(found);
      }
    }
    if (errno != 0 && !unread) unread = UnreadFolder{path, errno};
  }
  return unread;
}

}  // namespace etak
