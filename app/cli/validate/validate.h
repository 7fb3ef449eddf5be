// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/cache.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/validate/config.h"

namespace etak {
class CheckedBefore;  // core/validate/files/checked_before.h
}

namespace etak::cli {

/// The options of `etak validate`.
struct ValidateArguments {
  std::vector<std::string> paths;
  std::string files_from, changed_since, role, material, surface_class, today;
  ValidateSettings settings;
  std::optional<std::size_t> max_warnings;
  std::string min_severity;  // the text form leaves out findings below it
  bool allow_empty = false;  // a run with nothing to check is no failure
  bool exit_zero = false, list_rules = false, list_files = false, stats = false;
  std::string baseline, write_baseline, mask_folder, fix_folder;
  CacheArguments cache;
  bool watch = false;
  std::shared_ptr<CheckedBefore> before;  // of --watch, from one run to the next
  unsigned threads = 0;
  Library library;
  OutputArguments output;
};

/// Checks files, or lists them with --list-files. Returns the exit status; throws Error.
int check_files(ValidateArguments& arguments);

}  // namespace etak::cli
