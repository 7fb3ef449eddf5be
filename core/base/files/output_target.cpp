// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_target.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "core/base/files/output_folder.h"
#include "core/base/files/temporary.h"
#include "core/base/setting.h"
#include "core/base/system.h"

namespace etak {
namespace {

// Where a symbolic link leads, so that the link stays and its target is replaced.
std::string behind_links(const std::string& path) {
  const std::filesystem::path target = sys::canonical(path);
  return target.empty() ? path : sys::path_text(target);
}

}  // namespace

Error exists_already(const std::string& path) {
  return Error::at(path, "exists already", "a new name, or " + setting("force") + " to replace it");
}

FileTarget file_target(const std::string& path, bool overwrite) {
  FileTarget out;
  sys::FileInfo info;
  out.exists = sys::file_info(path, info);
  out.mode = info.mode & 0777;
  if (out.exists && info.kind == sys::FileInfo::Kind::folder)
    throw Error::at(path, "is a folder", "a file to write");
  out.is_device = out.exists && info.kind != sys::FileInfo::Kind::file;
  if (out.exists && !out.is_device && !overwrite) throw exists_already(path);
  const std::filesystem::path whole = out.exists ? behind_links(path) : path;
  out.folder = sys::path_text(whole.parent_path());
  out.name = sys::path_text(whole.filename());
  if (out.name.empty()) throw Error::at(path.empty() ? "\"\"" : path, "is no file's name", "a file to write");
  return out;
}

Descriptor open_folder_of(const FileTarget& target) {
  const std::string path = target.folder.empty() ? "." : target.folder;
  Descriptor out(sys::open_file(path, sys::Open::folder));
  // Files can also be made in a folder that may not be read.
  if (!out && errno == EACCES) out = Descriptor(sys::open_file(path, sys::Open::unreadable_folder));
  return out;
}

void check_file_target(const std::string& path, bool overwrite) {
  const FileTarget target = file_target(path, overwrite);
  if (target.is_device) return;
  const Descriptor folder = open_folder_of(target);
  if (!folder || !Temporary(folder.get(), target.name, Temporary::Kind::file))
    throw Error::at(path, "cannot be written: " + reason_of(errno));
}

void check_folder_target(const std::string& path, std::span<const std::string> names, Replace replace) {
  // Made beside the target and removed with the object.
  const OutputFolder probe(path, replace);
  if (replace != Replace::nothing) return;
  sys::FileInfo info;
  for (const std::string& name : names)
    if (sys::file_info(path + "/" + name, info)) throw exists_already(path + "/" + name);
}

void remove_remains(const std::string& path) {
  try {
    check_folder_target(path, {}, Replace::anything);
  } catch (const Error&) {
    // The next run that writes there removes them, or says why it cannot write.
  }
}

}  // namespace etak
