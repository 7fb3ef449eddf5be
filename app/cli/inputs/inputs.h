// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/exchange/material_input.h"

namespace etak::cli {

/// Adds INPUT... and --stdin-format; --dataset and --all belong to `etak f0`.
void add_input_options(Command verb, InputNames& names);
void add_all_datasets_option(Command verb, InputNames& names);

/// find_inputs() without texts that are no tables; remarks say what was left out.
std::vector<MaterialInput> find_tables(const InputNames& names, Library& library, unsigned threads,
                                       const OutputArguments& output);

/// The names in a list file, "-" for standard input: between NUL bytes when there is one, else between line
/// ends. Handed out in their order, so that a run over a million of them holds the text of the list and the
/// names at hand, and nothing else.
class ListedNames {
 public:
  /// Throws Error where the list cannot be read.
  explicit ListedNames(const std::string& path);

  /// The next names, at most so many; none at the end of the list.
  std::vector<std::string> take(std::size_t most = static_cast<std::size_t>(-1));

  /// Names and empty lines of the whole list.
  std::size_t count() const;

 private:
  std::string text_;
  char separator_;
  std::size_t at_ = 0;
};

}  // namespace etak::cli
