// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/pack/pack.h"
#include "core/runs/shards.h"

namespace etak::cli {

/// Packs one atlas and writes its report. Returns the exit status: 1 for findings that fail the run, 2 where
/// not everything could be checked. Throws Error.
int pack_once(PackArguments& arguments);

/// Packs every job of the file of --batch (parse_pack_jobs), in the order of the file, in this process. A job
/// that fails is reported, and the next job begins. Returns the highest exit status of all jobs. Throws Error
/// for a file of jobs that is not valid.
int pack_batch(PackArguments& arguments);

/// Throws Error where the line has no --batch, or holds an option with which it cannot be cut into shards.
void check_can_be_cut(const PackArguments& arguments, const std::vector<GivenOption>& line);

/// How pack_batch() would cut the jobs into `count` shards, and what each reads. Throws as it does.
std::vector<ShardPlan> plan_batch(const PackArguments& arguments, std::size_t count);

/// Packs the atlas, and packs it again whenever an input changes, until the process is interrupted.
int pack_watch(PackArguments& arguments);

}  // namespace etak::cli
