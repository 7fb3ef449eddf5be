// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/exchange/f0_worker.h"

namespace etak::cli {

/// The options of `etak f0`.
struct F0Arguments {
  InputNames inputs;
  std::string files_from;
  F0Settings compute;
  TableSettings tables;
  OutputArguments output;
  Library library;
  unsigned threads = 0;
  std::string sort;
  std::vector<std::string> without;
  std::string sweep;
  std::string coat;
  bool stats = false;
  bool verbose = false;
  bool bands = false;        // columns of the CSV
  bool allow_empty = false;  // the list of --files-from may be empty
};

/// Does the work of the verb. Returns the exit status; throws Error.
int answer_f0(F0Arguments& arguments);

/// The rows or the strip of --sweep for the one stack that is named, likewise.
int answer_film_sweep(F0Arguments& arguments, const F0Job& job);

}  // namespace etak::cli
