// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace etak::cli {

/// The files of a git working tree that have changed since a commit, as `git` tells them: those that differ
/// from where HEAD's branch and the commit parted, staged or not, and those that git does not know yet and is
/// not told to ignore. Deleted files are left out. Throws Error where git is missing or refuses.
///   commit   as git takes it: a branch, a tag, a hash
///   paths    files and folders to look at; none: the working folder
std::vector<std::string> changed_since(const std::string& commit, const std::vector<std::string>& paths);

}  // namespace etak::cli
