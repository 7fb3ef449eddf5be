// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/options/cache.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/pack/rects.h"
#include "core/atlas/pack/settings.h"
#include "core/validate/config.h"

namespace etak {
class PackCache;  // core/atlas/pack/pack_cache.h
}

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

}  // namespace etak::cli
