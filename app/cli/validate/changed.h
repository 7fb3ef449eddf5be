// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace etak::cli {

/// What has changed in a git working tree.
///   files     those that differ, and those that are new; where a file is gone, the files beside it
///   folders   to be searched whole: submodules at another commit, and repositories that git does not know
struct Changed {
  std::vector<std::string> files, folders;
};

/// What has changed since HEAD's branch and a commit parted, staged or not, and what git does not know yet and
/// is not told to ignore. git tells it, so that it runs no program which the repository names, and fetches
/// nothing. Submodules are asked in the same way what has changed in them. A file under a filter other than Git
/// LFS counts as changed where the index does not hold its size and times. Throws Error where git is missing or
/// refuses, where a path leads to nothing, for a link out of its folder, and for a submodule that has changed
/// and is not checked out.
///   commit   as git takes it: a branch, a tag, a hash
///   paths    files and folders to look at; none: the working folder
Changed changed_since(const std::string& commit, const std::vector<std::string>& paths);

}  // namespace etak::cli
