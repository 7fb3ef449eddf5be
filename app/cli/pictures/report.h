// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/output/output.h"
#include "core/study/stability/stability.h"

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

/// The work of `etak report`, in the module of pictures.h.
int measure(ReportArguments& arguments);

/// The cases of `etak stability` with what OpenGL gives, in the module too.
std::vector<StabilityCase> stability_on_gl(const std::string& device);

}  // namespace etak::cli
