// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "core/base/error.h"

namespace etak {

// Where output will go, looked at before long work: nobody waits for a result that cannot be put in place.
// The errors are those that write_file() and OutputFolder would end with.

/// What stands where a file is to be written.
struct FileTarget {
  bool exists = false;
  bool is_device = false;  // or a pipe: is written to and not replaced
  mode_t mode = 0;         // of the file that exists
  std::string path;        // behind a symbolic link, which stays
};
/// Throws Error for a folder, and for a file where `overwrite` is false.
FileTarget file_target(const std::string& path, bool overwrite);

/// The same, and Error where no file can be made beside the target (a temporary is made and removed).
void check_file_target(const std::string& path, bool overwrite);

/// The same for a folder of files (OutputFolder): throws Error where `path` is a file, where it can be
/// neither made nor changed, and, with `overwrite` false, where it holds one of `names`.
void check_folder_target(const std::string& path, std::span<const std::string> names, bool overwrite);

/// "PATH: exists already; expected a new name, or --force to replace it"
Error exists_already(const std::string& path);

}  // namespace etak
