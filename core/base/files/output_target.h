// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace etak {

// Checks of the place for output before long work, so that nobody waits for a result that cannot be put in
// place. The errors are those that write_file() and OutputFolder would end with.

/// What stands where a file is to be written.
struct FileTarget {
  bool exists = false;
  bool is_device = false;  // or a pipe: is written to and not replaced
  unsigned mode = 0;       // permissions of the file that exists
  std::string folder;      // behind a symbolic link, which stays; "" is the working folder
  std::string name;        // in it
};
/// Throws Error for a folder, and for a file where `overwrite` is false.
FileTarget file_target(const std::string& path, bool overwrite);

/// The folder that the target lies in. Nothing is open where that cannot be, and errno tells why.
Descriptor open_folder_of(const FileTarget& target);

/// Throws as file_target(), and where no file can be made beside the target (a temporary is tried).
void check_file_target(const std::string& path, bool overwrite);

/// What a folder of files may take the place of.
enum class Replace {
  nothing,   // a file of the set that the target already has is an Error
  files,     // files are replaced, but a target that nobody may write is an Error
  anything,  // and such a target is replaced as well
};

/// Looks at the target of a folder of files (OutputFolder): throws Error where `path` is a file, where it can be
/// neither made nor changed, and, with Replace::nothing, where it holds one of `names`.
void check_folder_target(const std::string& path, std::span<const std::string> names, Replace replace);

/// Removes what runs to this folder that were killed have left beside it, where nothing is to be written. It says
/// nothing where it cannot.
void remove_remains(const std::string& path);

/// "PATH: exists already; expected a new name, or force to replace it"; force as setting() says it
Error exists_already(const std::string& path);

}  // namespace etak
