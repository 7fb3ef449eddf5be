// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/options.h"

namespace etak::cli {

/// One thing that decides how etak works here.
///   from   who says so: a file, a variable of the environment, an option, or "default"
struct InForce {
  std::string name, value, from;
};

/// What is in force for a run in this folder: version, libraries, etak.toml, the user's own configuration,
/// OpenColorIO, and whether outputs replace files. Throws Error where one of them cannot be read.
std::vector<InForce> in_force(Library& library);

/// What every verb takes: -j, --progress, --stats and -v.
struct CommonArguments {
  unsigned threads = 0;
  std::string progress = "auto";
  bool stats = false, verbose = false;
};

/// Adds -j, --progress, --stats and -v to the verbs that do not have them, so that a script can give them to any
/// verb. Of these verbs none works long enough for threads or a progress to show.
void add_common_options(CommandLine& line, CommonArguments& arguments);

/// Does the work of a verb, and what -v and --stats of add_common_options() ask for.
int run_and_tell(const Work& work, const CommonArguments& arguments);

}  // namespace etak::cli
