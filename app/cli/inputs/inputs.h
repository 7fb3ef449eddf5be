// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/exchange/material_input.h"

namespace etak::cli {

/// Adds INPUT... and --stdin-format. Verbs that have --dataset and --all add these themselves.
void add_input_options(Command verb, InputNames& names);
void add_all_datasets_option(Command verb, InputNames& names);

/// find_inputs() without the text files of folders that hold no table; remarks tell how many were left out.
std::vector<MaterialInput> find_tables(const InputNames& names, Library& library, unsigned threads,
                                       const OutputArguments& output);

/// Adds --without ID/DATASET.
void add_without_option(Command verb, std::vector<std::string>& without);

/// The names in a list file ("-": standard input), separated by NUL bytes where the file has one, else by
/// line ends. take() hands them out in parts, so that a run over a million names holds only the text of the
/// list and the names that it works on.
class ListedNames {
 public:
  /// Throws Error where the list cannot be read.
  explicit ListedNames(const std::string& path);

  /// The next names, at most `most`; none at the end of the list.
  std::vector<std::string> take(std::size_t most = static_cast<std::size_t>(-1));

  /// The number of entries in the whole list, empty ones among them.
  std::size_t count() const;

 private:
  std::string text_;
  char separator_;
  std::size_t at_ = 0;
};

}  // namespace etak::cli
