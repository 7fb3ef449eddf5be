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

// The work of the verbs. Two bodies share these declarations: in etak-image (report_run.cpp) they measure; in
// etak (report_light.cpp), which links neither OpenGL nor the timing library, they become etak-image.
int measure(ReportArguments& arguments);
int show_stability(StabilityArguments& arguments);

}  // namespace etak::cli
