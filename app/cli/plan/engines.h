// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/runs/shards.h"

namespace etak::cli {

/// A task of a plan: one shard.
///   words    the program and its arguments
///   writes   the file that its output goes to
///   plan     what it reads; empty where that was not asked for
struct PlanTask {
  std::vector<std::string> words;
  std::string writes;
  ShardPlan plan;
};

/// A run cut into shards. Paths are relative to `folder`, or absolute.
///   folder    in which all commands run; absolute
///   out       folder of the plan and of what its tasks write; absolute
///   typed     the same as the user wrote it
///   merge     the command that joins the outputs, and the file that it writes; without words nothing is joined,
///             and a task that has failed (status 2) fails for its engine too
///   common    files that all tasks read: the configuration, a baseline
///   folders   whose entries decide the list of files
///   again     the command that makes the plan again
///   threads   the words say how many threads a task has
struct RunPlan {
  std::string folder, out, typed;
  std::vector<PlanTask> tasks;
  PlanTask merge;
  std::vector<std::string> common, folders, again;
  bool threads = false;
};

/// A plan as an engine reads it.
///   files   names in the folder of the plan, and bytes
///   next    what the user does with them
struct EnginePlan {
  std::vector<std::pair<std::string, std::string>> files;
  std::string next;
};

/// The engines: a template each (resources/pipelines/plan/NAME.in), and "json".
std::vector<std::string> plan_engines();
/// "slurm (array and merge), ..., json".
std::string plan_engines_text();

/// Whether the engine is told which files each task reads.
bool names_files(const std::string& engine);

/// The plan in the form of an engine: its template filled, or {"schema": "etak-plan/1", ...} as
/// resources/schema/plan.schema.json describes. Throws Error for a name that the engine has no way to write.
///
/// A template is text with these lines and values, of which the program quotes each as its words say:
///   %about TEXT          the engine, in the help
///   %needs WORD...       lines: a command is one line; utf-8: other names cannot be written
///   %threads TEXT        what a shell reads as the option for the threads of a task
///   %next TEXT           EnginePlan::next
///   %file NAME           the lines below are those of this file
///   %each task, %end     the lines between, for each task
///   %if merge, %else, %end
///   @{VALUE QUOTING...}  folder, out, typed, merge (words), result, common, folders, again, count, parts (what
///                        all tasks write); of a task: task (its command), index, shard, writes, files, list.
///                        Several are joined by blanks. shell: a word for a shell; dollar, percent: that
///                        character twice; path: absolute, in a line of ninja
EnginePlan engine_plan(const std::string& engine, const RunPlan& plan);

}  // namespace etak::cli
