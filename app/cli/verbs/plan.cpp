// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/cli/options/shard.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/pack/pack.h"
#include "app/cli/plan/engines.h"
#include "app/cli/validate/validate.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_tree.h"
#include "core/base/files/paths.h"
#include "core/base/number.h"
#include "core/base/system.h"
#include "core/findings/output/formats.h"
#include "core/runs/shards.h"
#include "core/validate/validate.h"

namespace etak::cli {
namespace {

struct PlanArguments {
  std::vector<std::string> words;  // the run: a verb and its arguments
  std::string format, out, program = "etak";
  unsigned tasks = 0;
  bool force = false, quiet = false;
};

// What is to be run, read as the verb itself will read it, so that a mistake is told now and not by every task.
//   line       what it gives
//   form_given   --format, or --report of pack, is on the line
//   validate, pack   the options, of these verbs
struct AskedRun {
  std::string verb;
  std::vector<GivenOption> line;
  bool form_given = false;
  std::shared_ptr<ValidateArguments> validate;
  std::shared_ptr<PackArguments> pack;
};

AskedRun read_run(std::vector<std::string> words) {
  if (words.empty())
    throw Error::at("etak plan", "nothing to run",
                    "-- and a verb with its arguments, such as -- validate textures");
  AskedRun out;
  out.verb = words.front();
  CommandLine line("", "etak");
  if (out.verb == "validate")
    declare_validate(line, out.validate = std::make_shared<ValidateArguments>());
  else if (out.verb == "pack")
    declare_pack(line, out.pack = std::make_shared<PackArguments>());
  else
    throw Error::at("etak plan", "the verb " + in_quotes(out.verb), "validate or pack, which have shards");
  words.insert(words.begin(), "etak");
  (void)line.read(words);
  const Command verb = line.verbs().front();
  out.line = verb.given();
  out.form_given = verb.find(out.pack ? "--report" : "--format")->given();
  for (const GivenOption& each : out.line)
    if (each.traits.in_shards == InShards::one_file)
      throw Error::at(each.name, "in the run of a plan", "the run without it");
  if (out.pack)
    check_can_be_cut(*out.pack, out.line);
  else
    check_can_be_cut(out.line);
  return out;
}

// The words that a task has of the line. Arguments stand last, behind --.
std::vector<std::string> words_of(const std::vector<GivenOption>& line) {
  std::vector<std::string> out, arguments{"--"};
  for (const GivenOption& each : line) {
    if (each.traits.in_shards == InShards::output) continue;
    for (const std::string& value : each.values)
      if (each.name.empty())
        arguments.push_back(value);
      else if (each.flag)
        out.push_back(each.name + (value == "true" ? "" : '=' + value));
      else
        out.insert(out.end(), {each.name, value});
  }
  if (arguments.size() > 1) out.insert(out.end(), arguments.begin(), arguments.end());
  return out;
}

std::string ending_of(const std::string& format) {
  return format == "junit" ? "xml" : format == "text" || format == "github" ? "txt" : format;
}

// The folders whose entries decide what a validation finds.
std::vector<std::string> folders_of(const std::vector<std::string>& paths) {
  std::set<std::string> out;
  for (const std::string& path : paths) {
    if (!is_folder(path)) continue;
    out.insert(path);
    const auto unread = walk_folder(path, true, [&](const FolderEntry& entry) {
      if (entry.kind == sys::FileInfo::Kind::folder) out.insert(entry.path);
    });
    if (unread)
      throw Error::at(unread->path, "cannot be opened: " + reason_of(unread->why), "a readable folder");
  }
  return {out.begin(), out.end()};
}

// What each task reads, for the engines that are told so.
std::vector<ShardPlan> planned_shards(const AskedRun& run, std::size_t count, RunPlan& plan) {
  if (run.validate) {
    ValidateArguments& a = *run.validate;
    if (!a.changed_since.empty())
      throw Error::at("--changed-since", "in a plan that names the files of each task", "a run over folders");
    ValidationRequest request = validation_request(a);
    for (const std::string& file : {request.config.file, a.baseline, a.files_from})
      if (!file.empty()) plan.common.push_back(file);
    plan.folders = folders_of(request.inputs.paths);
    return plan_shards(std::move(request), count);
  }
  plan.common.push_back(run.pack->batch);
  if (!run.pack->check.config.empty()) plan.common.push_back(run.pack->check.config);
  return plan_batch(*run.pack, count);
}

std::string told(const RunPlan& plan, const EnginePlan& of_engine) {
  return grouped(plan.tasks.size()) + (plan.tasks.size() == 1 ? " task" : " tasks") +
         (plan.merge.words.empty() ? "" : " and a merge that writes " + plan.merge.writes) +
         "; next: " + of_engine.next;
}

bool has_same_files(const std::string& folder, const EnginePlan& plan) {
  return std::ranges::all_of(plan.files, [&](const auto& file) {
    const std::string path = folder + '/' + file.first;
    return is_file(path) && read_file(path) == file.second;
  });
}

// A task, whose own options stand before those of the line.
PlanTask task_of(const AskedRun& run, const std::vector<std::string>& words, const std::string& program,
                 ShardPlan shard, const std::string& folder) {
  PlanTask out;
  out.writes = folder + "/part-" + std::to_string(shard.shard.index) + ".json";
  std::string part = shard.shard.text();
  if (const auto& items = shard.shard.items)
    part += ':' + std::to_string(items->first) + '-' + std::to_string(items->second);
  out.words = {program, run.verb, "--shard", part, "-q"};
  if (run.validate)
    out.words.insert(out.words.end(), {"--format", "json", "-o", out.writes, "--force"});
  else
    out.words.insert(out.words.end(), {"--batch-report", out.writes});
  if (run.pack && !run.form_given) out.words.insert(out.words.end(), {"--report", "none"});
  out.words.insert(out.words.end(), words.begin(), words.end());
  out.plan = std::move(shard);
  return out;
}

// The command that joins what the tasks write, in the form and into the file that the run asks for.
PlanTask merge_of(const AskedRun& run, const std::string& program, const RunPlan& plan) {
  const ValidateArguments& a = *run.validate;
  const bool file = !is_standard_output(a.output);
  const std::string format = run.form_given || file ? a.output.format : "json";
  PlanTask out;
  out.writes = file ? a.output.file : plan.out + "/result." + ending_of(format);
  out.words = {program, "merge"};
  for (const PlanTask& task : plan.tasks) out.words.push_back(task.writes);
  out.words.insert(out.words.end(), {"--format", format, "-o", out.writes, "--force", "-q"});
  if (!a.write_baseline.empty()) out.words.insert(out.words.end(), {"--write-baseline", a.write_baseline});
  return out;
}

int plan_run(const PlanArguments& a) {
  const AskedRun run = read_run(a.words);
  if (run.validate) {
    ValidateArguments& v = *run.validate;
    (void)validate_config(v.settings, v.paths.empty() ? "" : v.paths.front(), asked_materials(v.library));
  }
  RunPlan plan;
  plan.folder = sys::path_text(sys::working_folder());
  if (plan.folder.empty()) throw Error::at(".", reason_of(errno), "a file or folder that can be reached");
  plan.out = sys::path_text(sys::absolute(a.out).lexically_normal());
  while (plan.out.size() > 1 && plan.out.ends_with('/')) plan.out.pop_back();
  plan.typed = a.out;
  plan.threads = (run.pack ? run.pack->threads : run.validate->threads) > 0;
  std::vector<ShardPlan> shards;
  if (names_files(a.format))
    shards = planned_shards(run, a.tasks, plan);
  else
    for (std::size_t i = 1; i <= a.tasks; ++i) shards.push_back(ShardPlan{{i, a.tasks, {}}, {}, {}});
  const std::vector<std::string> words = words_of(run.line);
  for (ShardPlan& shard : shards)
    plan.tasks.push_back(task_of(run, words, a.program, std::move(shard), plan.out));
  if (run.validate) plan.merge = merge_of(run, a.program, plan);
  plan.again = {a.program,   "plan",    "--tasks", std::to_string(a.tasks),
                "--format",  a.format,  "-o",      plan.out,
                "--program", a.program, "--force", "-q",
                "--"};
  plan.again.insert(plan.again.end(), a.words.begin(), a.words.end());
  const EnginePlan of_engine = engine_plan(a.format, plan);
  // A plan that stays the same is not written again, so that no task runs because of it.
  if (!has_same_files(plan.out, of_engine)) {
    OutputTree folder(a.out, may_replace(a.force));
    for (const auto& [name, bytes] : of_engine.files) folder.write(name, bytes);
    folder.commit();
  }
  OutputArguments shown;
  shown.quiet = a.quiet;
  remark(shown, told(plan, of_engine));
  return exit_ok;
}

}  // namespace

void add_plan(CommandLine& line) {
  const auto arguments = std::make_shared<PlanArguments>();
  PlanArguments& a = *arguments;
  Command verb = line.verb("plan", "a run cut into tasks, as commands for an engine that starts them");
  verb.option("run", a.words, "-- and the run: validate or pack --batch with its arguments")
      .value_name("-- VERB ARGUMENT...");
  verb.option("--tasks", a.tasks, "how many shards the run is cut into")
      .range(1U, static_cast<unsigned>(most_shards))
      .value_name("N")
      .required();
  verb.option("--format", a.format, "the engine: " + plan_engines_text()).one_of(plan_engines()).required();
  verb.option("-o,--output,--out", a.out, "folder for the plan, and for what the tasks write")
      .value_name("DIR")
      .required();
  verb.option("--program", a.program, "etak on the machines of the engine").value_name("PATH").show_default();
  verb.flag("--force", a.force, "replace an earlier plan; ETAK_FORCE=1 says the same");
  verb.flag("-q,--quiet", a.quiet, "no remarks; errors still appear");
  verb.footer(
      "The result of validate has the form of --format or -o of the run, else JSON, and lies where -o of the run says, else in DIR. No task is started.\n"
      "Exit status: 0 the plan is written, 2 bad input, option or output.\n"
      "Example:\n  etak plan --tasks 4 --format slurm -o plan -- validate textures --format sarif");
  verb.runs([arguments] { return plan_run(*arguments); });
}

}  // namespace etak::cli
