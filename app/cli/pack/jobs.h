// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/pack/pack.h"
#include "core/atlas/pack/pack.h"

namespace etak::cli {

/// The typed choices as values. Throws Error that names the option.
PackOptions pack_options(const PackArguments& arguments);

/// One atlas, with its report. Returns the exit status: 1 for findings that fail the run.
int pack_once(PackArguments& arguments);

/// Reads a job file: {"jobs": [{"input", "out", and options by their long names}, ...]}; what a job does not
/// say is as on the command line. Paths are relative to the file. Throws Error.
std::vector<PackArguments> parse_jobs(std::string_view text, const std::string& file,
                                      const PackArguments& line);

/// Every job of --batch in the file's order, in this process; a job that fails is told and stops no other.
/// Returns the exit status: the worst of all.
int pack_batch(const PackArguments& arguments);

/// Packs, and again whenever an input changes, until the process is interrupted.
int pack_watch(PackArguments& arguments);

}  // namespace etak::cli
