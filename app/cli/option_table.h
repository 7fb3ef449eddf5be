// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace etak::cli {

/// Between the values that an option shows in the help.
inline constexpr const char* value_separator = " | ";

/// Heading of options that many verbs share.
inline constexpr const char* common_group = "Common";

/// What an option is to a run that is cut into shards.
enum class InShards {
  same,      // it may change the result: shards that differ in it belong to different runs, and do not join
  free,      // it changes no result, or what it changes is told by what the shard has read and found
  output,    // where the result goes, and in which form: in a plan that is for the merge
  one_file,  // a file that all tasks of a plan would write
  whole,     // it needs the whole run
};

/// What the declaration of an option says of its values, and of its part in a shard.
struct OptionTraits {
  std::string value;  // what stands for the value: "FILE", "N"; of an argument its name; empty for a flag
  std::vector<std::string> words;  // all values, where there are few
  std::string range;               // "1 to 256"
  InShards in_shards = InShards::same;
  bool reads_file = false;  // the value names a file, whose bytes count in place of its name
};
using TraitsOfOptions = std::map<const CLI::Option*, OptionTraits>;

/// An option or argument of a verb as the help shows it: what completions and manual pages are generated from.
struct OptionRow : OptionTraits {
  std::vector<std::string> names;  // with their dashes, short ones first; empty for an argument
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
