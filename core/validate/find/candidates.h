// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/judge/target.h"

namespace etak {

/// How a file was named. A file of an unchecked kind is an error where it was named by hand, else skipped.
enum class Named { by_hand, by_folder, by_list };

/// A file that a run may check.
///   searched   the folder whose search found it; else empty
///   plain      the search has seen that it is a file, and that no link leads to it
struct FileCandidate {
  std::string path;
  Named named = Named::by_hand;
  std::string searched;
  bool plain = false;
};

/// What a candidate is.
///   kind      none: of a kind that is not checked
///   missing   there is no such file
///   failure   why it cannot be told; empty: it can
struct KindOfFile {
  std::optional<FileRole> kind;
  bool missing = false;
  std::string failure;
};

/// The kinds of files, one for each, by their endings and contents. Tables of folders and lists that do not
/// look like spectra are of no kind; links that lead out of a searched folder are failures.
std::vector<KindOfFile> kinds_of(const std::vector<FileCandidate>& candidates, unsigned threads);

/// Adds the pictures that a file names, where it is a manifest of etak pack. They are judged while they are
/// packed. A file that is none, or that cannot be read, adds nothing.
void add_manifest_pictures(const std::string& path, std::unordered_set<std::string>& pictures);

}  // namespace etak
