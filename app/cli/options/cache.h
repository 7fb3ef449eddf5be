// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "app/cli/arguments.h"
#include "app/cli/output/output.h"
#include "core/runs/cache_folder.h"

namespace etak::cli {

/// A folder of earlier results, as typed.
struct CacheArguments {
  std::string folder, key, size, report;
  bool stats = false;
};

/// Adds --cache, --cache-key, --cache-size, --cache-stats and --cache-report.
///   kept   what an entry saves: "results here and do not check the same files again"
void add_cache_options(Command verb, CacheArguments& arguments, const std::string& kept);

/// The options of the line as values; without --cache the path is empty. Throws Error.
CacheOptions cache_options(const CacheArguments& arguments);

/// Checks before the work whether the file of --cache-report can be written. Throws Error.
///   replace   a file that exists may be replaced
void check_cache_report(const CacheArguments& arguments, bool replace);

/// Says why nothing was kept, where that is so, and what --cache-stats asks for.
void tell_cache(const CacheArguments& arguments, const CacheUse& use, const OutputArguments& output);

/// The file of --cache-report; null where none is asked for. Throws Error.
std::unique_ptr<Output> cache_report(const CacheArguments& arguments, const CacheUse& use, bool replace);

}  // namespace etak::cli
