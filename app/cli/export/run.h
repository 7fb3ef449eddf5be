// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/options/roughness.h"
#include "app/cli/output/output.h"

namespace etak::cli {

/// The options of `etak export`.
struct ExportArguments {
  InputNames inputs;
  F0Settings compute;
  TableSettings tables;
  OutputArguments output;
  Library library;
  std::string to, fit = "clamp", gltf_form = "metal-rough";
  std::vector<std::string> targets;
  std::vector<double> diffuse;
  RoughnessArguments rough;
  double opacity = 1;
  std::string shard;  // --shard as typed
  unsigned threads = 0;
};

/// Does the work of the verb. Returns the exit status; throws Error.
int export_materials(ExportArguments& arguments);

}  // namespace etak::cli
