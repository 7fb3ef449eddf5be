// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace etak::cli {

/// Between the values that an option shows in the help.
inline constexpr const char* value_separator = " | ";

/// Heading of options that many verbs share.
inline constexpr const char* common_group = "Common";

/// An option or argument of a verb as the help shows it: what completions and manual pages are generated from.
struct OptionRow {
  std::vector<std::string> names;  // with their dashes, short ones first; empty for an argument
  std::string value;  // what stands for the value: "FILE", "N"; of an argument its name; empty for a flag
  std::vector<std::string> words;  // all values, where there are few
  std::string range;               // "1 to 256"
  std::string standard;            // value without the option
  std::string help;
  std::string group;     // heading; empty for an argument
  bool repeats = false;  // may be given more than once
};

/// A verb, or etak itself in the first row of a table.
struct VerbRow {
  std::string name, help, footer;
  std::vector<OptionRow> options;
};

}  // namespace etak::cli
