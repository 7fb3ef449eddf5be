// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/shards/shards.h"
#include "core/validate/finding.h"
#include "core/validate/settings.h"
#include "core/validate/suppress.h"
#include "core/validate/verdict_options.h"

namespace etak {

/// What a report of a shard holds besides its findings: what merged_report() needs.
///   shard        with the groups of files that it takes
///   list         digest of everything that the whole run found: equal where the shards were cut from files of
///                the same names
///   options      digest of what decides the result besides the files
///   groups       number of groups of files of the whole run; a group is never cut
///   run          counts of the whole run
///   allowances   what became of the [[allow]] entries in this shard
struct ReportShard {
  Shard shard;
  std::string list, options;
  std::size_t groups = 0;
  RunCounts run;
  std::vector<AllowanceUse> allowances;
  Settings settings;
  VerdictOptions verdict;
};

/// Only the first so many files with findings get pictures on the HTML page, so that browsers can open the
/// page of a folder of thousands of files. A shard tells of so many files how to open them.
inline constexpr std::size_t most_files_with_pictures = 200;

/// Whether the HTML page has pictures of the file, while there is room.
inline bool may_have_pictures(const CheckedFile& file) {
  return file.target && !file.findings.empty() && !file.unreadable;
}

/// A report that the JSON form of a shard holds, and the version of etak that wrote it.
struct ReadShard {
  ValidationReport report;
  std::string version;
};

/// Throws Error naming `file` where the text is no JSON form of a shard.
ReadShard read_shard(std::string_view text, const std::string& file);

/// The report of the whole run. All shards are there, once each, in their order, and of one run (checked by
/// complete_shards()).
///   renew_known   everything found counts as known, in the place of the shards' baseline
ValidationReport merged_report(std::vector<ValidationReport> shards, bool renew_known);

}  // namespace etak
