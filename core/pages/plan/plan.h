// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/shards/shards.h"

namespace etak {

// A run cut into shards as commands for engines that start many tasks. Each form is a list of files, by their
// names in the folder of the plan.

/// A task of a plan: one shard.
///   words    the program and its arguments
///   writes   the file that its output goes to
///   plan     what it reads; empty where that was not asked for
struct PlanTask {
  std::vector<std::string> words;
  std::string writes;
  ShardPlan plan;
};

/// Paths are relative to `folder`, or absolute.
///   folder    in which all commands run; absolute
///   out       of the plan and of what its tasks write; absolute
///   merge     the command that joins the outputs, and the file that it writes; without words nothing is joined,
///             and a task that has failed (status 2) fails for its engine too
///   common    files that all tasks read: the configuration, a baseline
///   folders   whose entries decide the list of files
///   again     the command that makes the plan again
///   threads   the words say how many threads a task has
struct RunPlan {
  std::string folder, out;
  std::vector<PlanTask> tasks;
  PlanTask merge;
  std::vector<std::string> common, folders, again;
  bool threads = false;
};

using PlanFiles = std::vector<std::pair<std::string, std::string>>;  // name and bytes

/// A script for a task of a Slurm array, one for the merge, and submit.sh, which starts both with sbatch: the
/// merge runs when all tasks have ended well. A task that is merged ends well when its output is there, also
/// with findings.
PlanFiles slurm_plan(const RunPlan& plan);

/// A command a line, as OpenCue's cuecmd reads them, and the script of the merge. Throws Error for a line end in
/// a word.
PlanFiles cuecmd_plan(const RunPlan& plan);

/// A command a line and a script that gives them to GNU parallel and then runs the merge. Throws Error for a
/// line end in a word.
PlanFiles parallel_plan(const RunPlan& plan);

/// build.ninja: a task runs again where one of its files or a common file has changed, or its options; the plan
/// is made again where a folder has changed. Of another list of files all tasks run again, because the outputs
/// of a run hold its digest. For ninja -C in the folder of the plan. Throws Error for a line end in a word or
/// path.
PlanFiles ninja_plan(const RunPlan& plan);

/// {"schema": "etak-plan/1", ...} as resources/schema/plan.schema.json describes.
PlanFiles json_plan(const RunPlan& plan);

/// A word for a POSIX shell.
std::string shell_word(std::string_view word);

}  // namespace etak
