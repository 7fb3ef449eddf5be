// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "core/base/system.h"

namespace etak {

/// The files that a run reads, and all folders above them, by what they are: no link, no other spelling of a path and no
/// second mount of a folder hides one of them from an output that would take its place.
class ReadPlaces {
 public:
  /// Whether the folders above the files are held as well, each of which is looked up. An output that is one file
  /// can take the place of a file alone.
  enum class Of { files_alone, folders_too };

  explicit ReadPlaces(std::span<const std::string> paths = {}, Of of = Of::folders_too) {
    for (const std::string& path : paths) add(path, of);
  }
  /// A file or folder of the disk; a path that leads to nothing, or to a pipe, adds nothing.
  void add(const std::string& path, Of of = Of::folders_too);

  /// The path by which a file, or a folder that it is or lies in or below, was added first; null: it was not.
  const std::string* find(const sys::FileInfo& info) const;

  /// Throws Error where the file at `path`, or the folder, was added.
  void refuse(const sys::FileInfo& info, const std::string& path) const;

 private:
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::string> places_;
};

/// The permissions that all of the files give: the mode of what is made of them. Set-user and set-group bits are not
/// among them, and pipes are passed over.
unsigned strictest_mode(std::span<const std::string> files);

}  // namespace etak
