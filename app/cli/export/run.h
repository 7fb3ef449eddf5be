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
  std::vector<std::string> wanted;  // of --to, as typed
  std::string to, fit = "clamp", gltf_form = "specular-ior";
  std::vector<std::string> targets;
  std::string diffuse, emission;  // colours as typed
  RoughnessArguments rough;
  double opacity = 1;
  unsigned threads = 0;
};

/// The words that --to takes: mtlx, gltf, values, then the targets.
std::vector<std::string> forms_and_targets();

/// Does the work of the verb. Returns the exit status; throws Error.
int export_materials(ExportArguments& arguments);

}  // namespace etak::cli
