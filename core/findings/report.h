// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/findings/repair_report.h"
#include "core/judge/finding.h"
#include "core/judge/settings.h"
#include "core/runs/cache_use.h"

namespace etak {

struct KnownDefect;  // baseline.h

/// Numbers of files and checks of a run.
struct RunCounts {
  std::size_t files = 0;       // found
  std::size_t skipped = 0;     // found in folders and lists, of a kind that no rule checks
  std::size_t failed = 0;      // that cannot be checked at all
  std::size_t checks = 0;      // of files, pairs and sets
  std::size_t from_cache = 0;  // checks whose result came from the cache
  std::size_t unchanged = 0;   // checks whose result is that of an earlier run of the same program
};

/// Folders as the user typed them ("": the working folder), by the names that labels have for them, relative
/// to the run's root.
using TypedFolders = std::map<std::string, std::string>;

struct ReportShard;

/// The result of validate(): all files with their findings, and whether they pass.
struct ValidationReport {
  std::string profile, transfer, settings_hash;
  std::vector<CheckedFile> files;                   // in path order
  std::size_t errors = 0, warnings = 0, infos = 0;  // not counting suppressed and baseline ones
  bool passed = true;
  bool incomplete = false;              // something could not be checked: exit status 2
  bool stopped = false;                 // the run was stopped: files are missing
  bool nothing_checked = false;         // though the run had to check something: incomplete
  std::vector<std::string> not_opened;  // pipes, sockets and devices that folders hold
  std::vector<std::string> unknown;     // pictures of folders and lists whose names tell no role
  TypedFolders typed;
  RunCounts run;
  std::optional<CacheUse> cache;             // where the run had a cache
  std::optional<RepairReport> repairs;       // where repaired copies were asked for
  std::shared_ptr<const ReportShard> shard;  // shards/report_shard.h; null: the run was not cut
  bool merged = false;                       // from shards: the files themselves are not at hand
};

/// Puts checked files into a report: path order, sums, verdict (suppressed and baseline findings do not
/// count). Called again after findings have been marked.
ValidationReport report_of(std::vector<CheckedFile> files, const Settings& settings);

/// Where several sets find the same of a picture that they share, adds to each finding which set it is of. Done
/// last, in reports of whole runs only: a shard does not know the sets of the others.
void tell_sets_apart(ValidationReport& report);

/// What report_of_run() needs besides the settings.
///   config        file of the configuration, for messages and findings
///   today         "YYYY-MM-DD" for allowances that expire; empty: the system's date
///   whole_tree    everything below the configuration's folder was looked at
///   known         findings of a baseline
///   renew_known   everything that is found counts as known, instead of `known`
///   shard         of a shard: it takes the use of the allowances, and none is reported as unused
struct ReportRun {
  std::string config = {}, today = {};
  bool whole_tree = false;
  std::span<const KnownDefect> known = {};
  bool renew_known = false;
  ReportShard* shard = nullptr;
};

/// The system's date, "YYYY-MM-DD".
std::string today_here();

/// report_of(), with the hash of the settings, and with the findings marked that the settings allow or that are
/// known.
ValidationReport report_of_run(std::vector<CheckedFile> files, const Settings& settings,
                               const ReportRun& run);

}  // namespace etak
