// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/read_places.h"

#include <filesystem>

#include "core/base/error.h"

namespace etak {

void ReadPlaces::add(const std::string& path, Of of) {
  namespace fs = std::filesystem;
  const auto info_of = [](const fs::path& at, sys::FileInfo& info) {
    return sys::file_info(sys::path_text(at), info) &&
           (info.kind == sys::FileInfo::Kind::file || info.kind == sys::FileInfo::Kind::folder);
  };
  sys::FileInfo info;
  if (!info_of(path, info)) return;
  if (of == Of::files_alone) {
    places_.try_emplace({info.device, info.number}, path);
    return;
  }
  const fs::path typed = sys::absolute(path);
  // Above a link lie the folders of its name and those of its target.
  for (const fs::path& whole : {sys::canonical(typed), typed.lexically_normal()})
    for (fs::path at = whole; !at.empty(); at = at.parent_path()) {
      const bool fresh = !info_of(at, info) || places_.try_emplace({info.device, info.number}, path).second;
      // The folders above a known one are known too.
      if ((!fresh && at != whole) || at == at.parent_path()) break;
    }
}

const std::string* ReadPlaces::find(const sys::FileInfo& info) const {
  const auto found = places_.find({info.device, info.number});
  return found == places_.end() ? nullptr : &found->second;
}

void ReadPlaces::refuse(const sys::FileInfo& info, const std::string& path) const {
  if (const std::string* const read = find(info))
    throw Error::at(
        path,
        (info.kind == sys::FileInfo::Kind::folder ? "is or holds " : "is the input ") + printable(*read, 200),
        "an output beside the inputs: none is written over");
}

unsigned strictest_mode(std::span<const std::string> files) {
  unsigned out = 0777;
  sys::FileInfo info;
  for (const std::string& file : files)
    if (sys::file_info(file, info) && info.kind == sys::FileInfo::Kind::file) out &= info.mode;
  return out;
}

}  // namespace etak
