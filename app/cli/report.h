// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/output.h"

namespace etak::cli {

/// `etak report` as typed.
struct ReportArguments {
  std::vector<std::string> families;  // empty: all
  std::string folder;
  std::string device = "cpu", progress = "auto";
  bool quick = false, full = false, force = false, quiet = false;
  unsigned threads = 0;
};

/// `etak stability` as typed.
struct StabilityArguments {
  OutputArguments output;
  std::string device = "cpu";
};

// The work of the verbs, in the module of pictures.h.
int measure(ReportArguments& arguments);
int show_stability(StabilityArguments& arguments);

}  // namespace etak::cli
