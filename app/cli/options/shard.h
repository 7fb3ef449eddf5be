// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/shards/shards.h"

namespace etak::cli {

/// Adds --shard to a verb whose work can be cut into parts for several machines.
void add_shard_option(Command verb, std::string& text);

/// The part that --shard asks for: "2/4", or by "slurm" that of the array of jobs that Slurm's variables tell
/// of. nullopt where `text` is empty: the variables alone cut nothing. Throws Error.
std::optional<Shard> asked_shard(const std::string& text);

/// Throws Error for standard input or a pipe among the inputs of a shard: a pipe can be read by one program
/// only.
void refuse_pipes_of_shard(const std::vector<std::string>& inputs);

}  // namespace etak::cli
