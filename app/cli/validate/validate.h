// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/cache.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/validate/config.h"

namespace etak::cli {

/// The value of --fail-on with which findings are reported but do not change the exit status.
inline constexpr const char* never_fails = "never";

/// The options of `etak validate`.
struct ValidateArguments {
  std::vector<std::string> paths;
  std::string files_from, changed_since, role, material, surface_class, alpha;
  std::string config, profile, transfer, fail_on, today;
  bool no_config = false;
  RuleChoice choice;
  std::optional<std::size_t> max_warnings;
  std::string min_severity;  // the text form leaves out findings below it
  bool allow_empty = false;  // a run with nothing to check is no failure
  bool exit_zero = false, list_rules = false, list_files = false, stats = false;
  std::string baseline, write_baseline, mask_folder, fix_folder;
  CacheArguments cache;
  unsigned threads = 0;
  Library library;
  OutputArguments output;
};

/// Checks files, or lists them with --list-files. Returns the exit status; throws Error.
int check_files(ValidateArguments& arguments);

}  // namespace etak::cli
