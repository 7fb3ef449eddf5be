// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include "app/cli/output/output.h"

namespace etak::cli {

/// Whether outputs may replace existing files. --force allows it; else ETAK_FORCE=1 or 0 in the environment
/// decides, else `force` in the user's own configuration (core/validate/user_config.h). Throws Error where
/// ETAK_FORCE or the configuration cannot be understood.
bool may_replace(bool force);

/// Throws Error where the file of an output is one of those that the line names to be read, or of `more`.
void refuse_input(const std::string& file, std::span<const std::string> more = {});

/// Whether outputs may replace existing files where --force is not given, and who says so.
struct ReplaceDefault {
  bool replace = false;
  std::string from;
};
ReplaceDefault replace_default();

/// Checks before long work whether the file of -o can be written: throws the Error that write_output() would
/// throw after it, also where it is an input of the run. Standard output always passes.
void check_output(const OutputArguments& arguments);

/// Whether the file of --write-baseline is a baseline, which is replaced without --force; false where there is none.
/// Throws Error where it can not be written, or is anything else: with --force, too, it is not replaced.
bool replaces_baseline(const std::string& path);

/// An output of a run: the option that asks for it, and its path; "" and "-" stand for none.
struct NamedOutput {
  const char* option;
  std::string path;
};
/// Throws Error where two outputs have one name, by whatever spelling, link or mount of their folder.
void refuse_same_outputs(std::initializer_list<NamedOutput> outputs);

}  // namespace etak::cli
