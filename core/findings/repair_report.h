// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace etak {

/// What the repair of one rule has done to one file.
///   rule, slug   "ETK402", "specular-double-encoded"
///   what         "undid the second sRGB encoding"
///   texels       that it changed
///   also         other rules whose findings in the set went with it, sorted
struct RepairStep {
  std::string rule, slug, what;
  std::size_t texels = 0;
  std::vector<std::string> also = {};
  friend bool operator==(const RepairStep&, const RepairStep&) = default;
};

/// A file that was written beside others of its set: repaired, or copied byte for byte.
struct RepairedFile {
  std::string file;                   // the original, relative to the run's root
  std::string copy;                   // its path below the folder of copies
  std::vector<RepairStep> steps;      // in the order in which they were done; empty: a copy
  std::size_t texels = 0, of = 0;     // that differ from the original's, and all of them
  std::vector<std::string> not_kept;  // "the chunk tIME", "the palette"; of a copy nothing
  friend bool operator==(const RepairedFile&, const RepairedFile&) = default;
};

/// Findings of one rule in one file that were not repaired, or not wholly.
struct LeftFinding {
  std::string rule, slug, file;
  std::string why;
  friend bool operator==(const LeftFinding&, const LeftFinding&) = default;
};

/// The repairs that were made, and the findings that were left.
struct RepairReport {
  std::string folder;               // of the copies, as the user named it
  std::vector<RepairedFile> files;  // in the order of the report, set by set
  std::vector<LeftFinding> left;    // likewise
  friend bool operator==(const RepairReport&, const RepairReport&) = default;
};

}  // namespace etak
