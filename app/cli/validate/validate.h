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
#include "core/base/files/output.h"
#include "core/findings/shards/report_shard.h"
#include "core/validate/config.h"
#include "core/validate/validate.h"

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
  std::string shard, line_digest;  // --shard as typed, and with it line_digest() of the line
  bool watch = false;
  std::shared_ptr<CheckedBefore> before;  // of --watch, from one run to the next
  unsigned threads = 0;
  Library library;
  OutputArguments output;
};

/// Adds the verb to `line`, which reads its options into `arguments`.
void declare_validate(CommandLine& line, const std::shared_ptr<ValidateArguments>& arguments);

/// Checks files, or lists them with --list-files. Returns the exit status; throws Error.
int check_files(ValidateArguments& arguments);

/// Tells on standard error what was not checked, and why.
void tell_not_found(const ValidateArguments& arguments, const ValidationReport& report);

/// Writes what a run has found, also the baseline of --write-baseline: the end of check_files() and of the
/// merge of shards. Returns the exit status; throws Error.
///   verdict   what decides the status besides the findings
///   beside    outputs that are put in place together with the report; null ones are passed over
int finish_report(const ValidateArguments& arguments, const Settings& settings, const VerdictOptions& verdict,
                  ValidationReport& report, std::vector<Output*> beside);

/// The verdict that the options ask for.
VerdictOptions verdict_options(const ValidateArguments& arguments);

/// The materials of the library with the folders of --library and ETAK_LIBRARY; null where there are no such
/// folders, which stands for the built-in library. Throws Error for a folder that cannot be read.
std::shared_ptr<const KnownMaterials> asked_materials(Library& library);

/// The request for validate() that the line describes. Throws Error.
ValidationRequest validation_request(ValidateArguments& arguments);

/// Checks the files, and again whenever one of them changes, until the process is interrupted. Throws Error for
/// options that do not go with it, and what the first check throws.
int watch_files(ValidateArguments& arguments);

}  // namespace etak::cli
