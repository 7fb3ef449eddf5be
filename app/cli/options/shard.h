// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "core/runs/shards.h"

namespace etak::cli {

/// Adds --shard to a verb whose work can be cut into parts for several machines.
void add_shard_option(Command verb, std::string& text);

/// The part that --shard asks for: "2/4", or by "slurm" that of the array of jobs that Slurm's variables tell
/// of. nullopt where `text` is empty: the variables alone cut nothing. Throws Error.
std::optional<Shard> asked_shard(const std::string& text);

/// Throws Error where the line gives an option that needs the whole run, and for standard input or a pipe, which
/// one program alone can read.
void check_can_be_cut(const std::vector<GivenOption>& line);

/// A digest of what the line gives and may change the result (InShards::same): the values of options, and the
/// bytes of the files that they name. Equal for lines that differ in the order of their options. Throws Error
/// where such a file cannot be read.
std::string line_digest(const std::vector<GivenOption>& line);

}  // namespace etak::cli
