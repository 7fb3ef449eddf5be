// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/options/roughness.h"
#include "app/cli/output/output.h"

namespace etak::cli {

/// `etak choose` as typed.
struct ChooseArguments {
  std::vector<std::string> materials;
  std::string costs;  // file of a cost table
  double budget = 1;
  RoughnessArguments rough;
  bool codes = false, all = false, measure = false, write_costs = false;
  Library library;
  unsigned threads = 0;
  OutputArguments output;
};

/// The work of the verb, in the module of pictures.h.
int choose_materials(ChooseArguments& arguments);

}  // namespace etak::cli
