// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"

namespace etak::cli {

/// The options of `etak choose`.
struct ChooseArguments {
  std::vector<std::string> materials;
  TableSettings tables;
  std::string dataset;  // of each, in place of the preferred one
  std::string costs;    // path of a cost table; empty: the table that etak holds
  double budget = 1;
  RoughnessArguments rough;
  bool codes = false, all = false, measure = false, write_costs = false;
  Library library;
  unsigned threads = 0;
  OutputArguments output;
};

/// Does the work of the verb, in the module of pictures.h. Returns the exit status; throws Error.
int choose_materials(ChooseArguments& arguments);

}  // namespace etak::cli
