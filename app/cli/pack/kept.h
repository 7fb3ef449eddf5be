// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/cli/pack/pack.h"
#include "core/atlas/pack/pack_cache.h"
#include "core/validate/config.h"

namespace etak::cli {

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
