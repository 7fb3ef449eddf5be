// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/cache.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/pack/rects.h"
#include "core/pack/pack_cache.h"
#include "core/pack/settings.h"
#include "core/runs/shards.h"
#include "core/validate/config.h"

namespace etak::cli {

/// The options of `etak pack`.
struct PackArguments {
  PackSettings settings;   // of the atlas; every job of --batch has its own
  ValidateSettings check;  // of its pages
  std::string format;      // of --format as typed
  std::string batch, batch_report, shard, memory, report = "text", page_report, progress = "auto";
  std::vector<std::string> page_links;
  bool update = false, dry_run = false, watch = false, stats = false, force = false, quiet = false;
  bool no_validate = false;
  unsigned threads = 0;
  Library library;
  PackRectsArguments rects;
  CacheArguments cache;
  std::shared_ptr<PackCache> kept;  // of --cache, while a run goes on; null: none
  std::string told;  // with --batch-report: the report of the atlas that was packed last, as JSON
};

/// How remarks and progress of the run are to be shown.
OutputArguments shown_as(const PackArguments& arguments);

/// Adds the verb to `line`, which reads its options into `arguments`.
void declare_pack(CommandLine& line, const std::shared_ptr<PackArguments>& arguments);

/// Does the work of the verb. Returns the exit status; throws Error.
int pack_atlas(PackArguments& arguments);

/// Packs one atlas and writes its report. Returns the exit status: 1 for findings that fail the run, 2 where
/// not everything could be checked. Throws Error.
int pack_once(PackArguments& arguments);

/// Packs every job of the file of --batch (parse_pack_jobs), in the order of the file, in this process. A job
/// that fails is reported, and the next job begins. Returns the highest exit status of all jobs. Throws Error
/// for a file of jobs that is not valid.
int pack_batch(PackArguments& arguments);

/// Throws Error where the line has no --batch, or holds an option with which it cannot be cut into shards.
void check_can_be_cut(const PackArguments& arguments, const std::vector<GivenOption>& line);

/// How pack_batch() would cut the jobs into `count` shards, and what each reads. Throws as it does.
std::vector<ShardPlan> plan_batch(const PackArguments& arguments, std::size_t count);

/// Packs the atlas, and packs it again whenever an input changes, until the process is interrupted.
int pack_watch(PackArguments& arguments);

/// All that decides the result of a job, besides the files that its input names. Throws Error for a folder of
/// --library that cannot be read.
///   config        of the check; null: the atlas is not checked
///   space_config  the file of an OpenColorIO config; empty: etak's own
PackJobIdentity identity_of(const PackArguments& arguments, const ValidateConfig* config,
                            const std::string& space_config);

/// Puts the atlas of that key in place where the cache holds it and another one is there. Returns what is to be
/// said; nothing where the atlas has to be packed. Throws Error where it may not be written.
std::optional<PackTold> atlas_from_cache(const PackArguments& arguments, const std::string& key);

/// Does the work of one run with the cache of --cache, where one is given, and tells of it. Returns what
/// work(arguments) returns.
///   again   the run is not the first one of --watch: its own file of --cache-report may be replaced
int with_cache(PackArguments& arguments, int (*work)(PackArguments&), bool again = false);

}  // namespace etak::cli
