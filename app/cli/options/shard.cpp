// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/shard.h"

#include <cstdlib>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/hash/content_hash.h"
#include "core/base/number.h"

namespace etak::cli {
namespace {

constexpr const char* option = "--shard";

std::optional<std::size_t> number_in(const std::string& variable) {
  const char* const value = std::getenv(variable.c_str());
  if (value == nullptr) return std::nullopt;
  const auto out = whole_number<std::size_t>(value);
  if (!out || *out > most_shards)
    throw Error::at(option, variable + " is " + in_quotes(value),
                    "a whole number, as Slurm sets it in an array");
  return out;
}

std::size_t needed_number(const std::string& variable) {
  const auto out = number_in(variable);
  if (!out)
    throw Error::at(option, "slurm, but " + variable + " is not set",
                    "a task of an array (sbatch --array=1-N), or i/n such as 2/4");
  return *out;
}

Shard shard_of_slurm() {
  const std::size_t id = needed_number("SLURM_ARRAY_TASK_ID"), least = needed_number("SLURM_ARRAY_TASK_MIN"),
                    most = needed_number("SLURM_ARRAY_TASK_MAX");
  if (const auto step = number_in("SLURM_ARRAY_TASK_STEP"); step && *step != 1)
    throw Error::at(option, "slurm with a step of " + std::to_string(*step) + " in the array",
                    "an array without a step, such as --array=1-4");
  if (id < least || id > most)
    throw Error::at(option,
                    "slurm with SLURM_ARRAY_TASK_ID " + std::to_string(id) + " outside of " +
                        std::to_string(least) + " to " + std::to_string(most),
                    "the variables of one array");
  if (const auto count = number_in("SLURM_ARRAY_TASK_COUNT"); count && *count != most - least + 1)
    throw Error::at(
        option,
        "slurm with an array of " + std::to_string(*count) + " tasks from " + std::to_string(least) + " to " +
            std::to_string(most),
        "an array without gaps, or i/n such as --shard $SLURM_ARRAY_TASK_ID/4 to run some tasks again");
  return {id - least + 1, most - least + 1};
}

}  // namespace

void add_shard_option(Command verb, std::string& text) {
  verb.option(
          "--shard", text,
          "only the part I of N of the work, which etak merge joins; slurm: the part of this task of a Slurm array")
      .value_name("I/N|slurm")
      .in_shards(InShards::one_file);
}

std::optional<Shard> asked_shard(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "slurm") return shard_of_slurm();
  const auto out = shard_named(text);
  if (!out) throw Error::at(option, printable(text), "I/N with 1 <= I <= N, such as 2/4, or slurm");
  return out;
}

void check_can_be_cut(const std::vector<GivenOption>& line) {
  for (const GivenOption& each : line) {
    if (each.traits.in_shards == InShards::whole)
      throw Error::at(each.name, "in a run that is cut into shards", "one of both");
    for (const std::string& value : each.values)
      if (each.traits.reads_file && is_pipe_input(value))
        throw Error::at(option, typed_input(value) + " is a pipe, which one program alone can read",
                        "files and folders that every task can read");
  }
}

std::string line_digest(const std::vector<GivenOption>& line) {
  ContentHash hash;
  for (const GivenOption& each : line) {
    if (each.traits.in_shards != InShards::same || each.standard) continue;
    hash.add_part(each.name);
    for (const std::string& value : each.values)
      hash.add_part(each.traits.reads_file ? read_file(value) : value);
  }
  return hash.hex();
}

}  // namespace etak::cli
