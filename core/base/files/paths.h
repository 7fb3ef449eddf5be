// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/system.h"

namespace etak {

/// What there is at a path; none where there is nothing or where it cannot be asked, and errno tells why.
///   follow   what a link leads to; else a link is a link
std::optional<sys::FileInfo::Kind> kind_at(const std::string& path, bool follow = true);

bool is_there(const std::string& path);
bool is_file(const std::string& path);
bool is_folder(const std::string& path);
bool is_link(const std::string& path);

/// The path from the root on, without links, "." and ".." as far as something is there.
std::filesystem::path plain_path(const std::filesystem::path& path);

/// The bytes of a file. Throws Error that names the path where there is none.
std::uint64_t size_of_file(const std::string& path);

/// Makes the folder and those above it, as far as nothing has their names; false where one cannot be made, and errno
/// tells why.
///   made   gets those that were made
bool make_folders(const std::filesystem::path& folder, std::vector<std::string>* made = nullptr);

/// What a walk through a folder meets.
struct FolderEntry {
  std::string path;  // with that of the folder
  std::string_view name;
  sys::FileInfo::Kind kind{};  // of what a link leads to; `link` where it leads to nothing
  bool linked = false;         // the entry itself is a link
};
struct UnreadFolder {
  std::string path;
  int why = 0;  // errno
};
/// Hands all that a folder holds to `take`, in no order.
///   below     of the folders in it, too, unless they are linked
///   returns   the first folder that could not be read
std::optional<UnreadFolder> walk_folder(const std::string& folder, bool below,
                                        const std::function<void(const FolderEntry&)>& take);

}  // namespace etak
