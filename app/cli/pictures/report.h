// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/output/output.h"
#include "core/study/stability/stability.h"

namespace etak::cli {

/// The options of `etak report`.
struct ReportArguments {
  std::vector<std::string> families;  // empty: all
  std::string folder;
  std::string device = "cpu", progress = "auto";
  bool quick = false, full = false, force = false, quiet = false;
  unsigned threads = 0;
};

/// Does the work of `etak report`, in the module of pictures.h. Returns the exit status; throws Error.
int measure(ReportArguments& arguments);

/// The cases of `etak stability`, evaluated by OpenGL as well, in the same module. Throws Error where there
/// is no OpenGL.
///   device   value of --device, for the message of the error
std::vector<StabilityCase> stability_on_gl(const std::string& device);

}  // namespace etak::cli
