// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/validate/config.h"

namespace etak::cli {

/// --fail-on never: findings are told and do not change the exit status.
inline constexpr const char* never_fails = "never";

/// `etak validate` as typed.
struct ValidateArguments {
  std::vector<std::string> paths;
  std::string files_from, role, material, surface_class, alpha;
  std::string config, profile, transfer, fail_on, today;
  bool no_config = false;
  RuleChoice choice;
  std::optional<std::size_t> max_warnings;
  std::string min_severity;  // of the text form
  bool allow_empty = false;  // nothing to check is no failure
  bool exit_zero = false, list_rules = false, list_files = false, stats = false;
  std::string baseline, write_baseline, mask_folder, cache_folder, cache_key;
  unsigned threads = 0;
  Library library;
  OutputArguments output;
};

/// The work of the verb where files are checked.
int check_files(ValidateArguments& arguments);

}  // namespace etak::cli
