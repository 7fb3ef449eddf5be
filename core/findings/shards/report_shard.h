// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/findings/report.h"
#include "core/findings/suppress.h"
#include "core/findings/verdict_options.h"
#include "core/judge/settings.h"
#include "core/runs/shards.h"

namespace etak {

/// What a report of a shard holds besides its findings: what merged_report() needs.
///   shard        with the groups of files that it takes
///   list         digest of everything that the whole run found: equal where the shards were cut from files of
///                the same names
///   options      digest of what decides the result besides the files
///   groups       number of groups of files of the whole run; a group is never cut
///   run          counts of the whole run
///   allowances   what became of the [[allow]] entries in this shard
///   settings     read from a document, only what a report says of them: profile, transfer, fail_on
struct ReportShard {
  Shard shard;
  std::string list, options;
  std::size_t groups = 0;
  RunCounts run;
  std::vector<AllowanceUse> allowances;
  Settings settings;
  VerdictOptions verdict;
};

/// A report that was read from the JSON form of a shard.
///   file   that holds it, for messages
struct ReadShard {
  std::string file;
  ValidationReport report;
};

/// Reads the JSON form of a shard. The document carries the SHA-256 of its own bytes (with zeros in the place
/// of those digits), which shows damage. A stranger can compute it too; so every value must also be one that
/// etak writes there, and the document must be, byte for byte, what etak writes for these values. Throws Error
/// with the file and the place where one of that does not hold.
///   version   of the program, which must have written the shard
ReadShard read_shard(std::string_view text, const std::string& file, std::string_view version);

/// The report of the whole run. Throws Error that names the file of a shard that is of another run than the
/// first (number of shards, options, list of files), that is there twice, or whose groups do not follow those
/// of the shard before it; and an Error that names the shards that are missing.
///   shards        at least one, in any order
///   renew_known   everything found counts as known, in the place of the shards' baseline
ValidationReport merged_report(std::vector<ReadShard> shards, bool renew_known);

}  // namespace etak
