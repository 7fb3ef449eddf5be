// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/cli/output/output.h"

namespace etak::cli {

/// The options of `etak plan`.
struct PlanArguments {
  std::vector<std::string> words;  // the run: a verb and its arguments
  std::string format, out, program = "etak";
  unsigned tasks = 0;
  bool force = false, quiet = false;
};

/// Writes the plan of a run. Returns the exit status; throws Error.
int plan_run(const PlanArguments& arguments);

}  // namespace etak::cli
