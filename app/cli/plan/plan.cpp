// SPDX-License-Identifier: Apache-2.0
#include "app/cli/plan/plan.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "app/cli/output/replace.h"
#include "app/cli/pack/jobs.h"
#include "app/cli/validate/request.h"
#include "app/cli/validate/validate.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_tree.h"
#include "core/base/number.h"
#include "core/base/system.h"
#include "core/findings/output/formats.h"
#include "core/pages/plan/plan.h"
#include "core/validate/validate.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

// What is to be run.
//   words      without the options that belong to the output, which the tasks and the merge have of their own
//   format     of the result, and its file; empty: none was asked for
//   form_given   --format, or --report of pack, is among the words
//   validate, pack   the options, of these verbs
struct AskedRun {
  std::string verb, format, result, baseline;
  std::vector<std::string> words;
  bool threads = false, form_given = false;
  std::shared_ptr<ValidateArguments> validate;
  std::shared_ptr<PackArguments> pack;
};

// Takes the options of these names out of the words, with their values where they have one: "--format X",
// "--format=X", "-oX".
void take_out(std::vector<std::string>& words, const std::vector<std::string>& names, bool has_value) {
  for (auto word = words.begin(); word != words.end() && *word != "--";) {
    const bool alone = std::ranges::count(names, *word) > 0;
    const auto holds_value = [&](const std::string& name) {
      return word->starts_with(name.starts_with("--") ? name + '=' : name);
    };
    if (alone && has_value && word + 1 != words.end())
      word = words.erase(word, word + 2);
    else if (alone || (has_value && std::ranges::any_of(names, holds_value)))
      word = words.erase(word);
    else
      ++word;
  }
}

// Reads the words as the verb itself will, so that a mistake is told now and not by every task.
//   words   the verb and its arguments
AskedRun read_words(std::vector<std::string> words) {
  AskedRun out;
  out.verb = words.front();
  out.words.assign(words.begin() + 1, words.end());
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
  for (const char* help : {"--help", "--help-all"})
    if (verb.find(help)->given()) throw Error::at(help, "in the run of a plan", "the run without it");
  out.form_given = verb.find(out.pack ? "--report" : "--format")->given();
  return out;
}

// Throws Error for options with which the run cannot be cut, or with which all tasks would write one file.
void check_tasks(const AskedRun& run) {
  const std::string& shard = run.pack ? run.pack->shard : run.validate->shard;
  const CacheArguments& cache = run.pack ? run.pack->cache : run.validate->cache;
  const bool page = run.pack && !run.pack->page_report.empty();
  for (const auto& [option, given] : {std::pair{"--shard", !shard.empty()},
                                      {"--cache-report", !cache.report.empty()},
                                      {"--page-report", page}})
    if (given) throw Error::at(option, "in the run of a plan", "the run without it");
  if (run.pack)
    check_can_be_cut(*run.pack);
  else
    check_can_be_cut(*run.validate);
}

AskedRun read_run(const std::vector<std::string>& words) {
  if (words.empty())
    throw Error::at("etak plan", "nothing to run",
                    "-- and a verb with its arguments, such as -- validate textures");
  AskedRun out = read_words(words);
  check_tasks(out);
  out.threads = (out.pack ? out.pack->threads : out.validate->threads) > 0;
  if (out.pack) {
    take_out(out.words, {"--batch-report"}, true);
  } else {
    ValidateArguments& a = *out.validate;
    (void)validate_config(a.settings, a.paths.empty() ? "" : a.paths.front(), asked_materials(a.library));
    if (!is_standard_output(a.output)) out.result = a.output.file;
    out.format = out.form_given || !out.result.empty() ? a.output.format : "json";
    out.baseline = a.write_baseline;
    take_out(out.words, {"--format", "-o", "--output", "--write-baseline"}, true);
    take_out(out.words, {"--force"}, false);
  }
  take_out(out.words, {"-q", "--quiet"}, false);
  // What is left may still hold an output in a spelling that the words do not show, such as -qo FILE.
  std::vector<std::string> left = out.words;
  left.insert(left.begin(), out.verb);
  const AskedRun rest = read_words(left);
  if (rest.pack
          ? !rest.pack->batch_report.empty()
          : rest.form_given || !rest.validate->output.file.empty() || !rest.validate->write_baseline.empty())
    throw Error::at("etak plan", "an output in one word with other options, such as -qo FILE",
                    "-o, --format, --write-baseline or --batch-report as a word of its own");
  return out;
}

std::string ending_of(const std::string& format) {
  return format == "junit" ? "xml" : format == "text" || format == "github" ? "txt" : format;
}

// The folders whose entries decide what a validation finds.
std::vector<std::string> folders_of(const std::vector<std::string>& paths) {
  std::set<std::string> out;
  for (const std::string& path : paths) {
    std::error_code failure;
    if (!fs::is_directory(path, failure)) continue;
    out.insert(path);
    for (fs::recursive_directory_iterator at(path, failure), end; !failure && at != end;
         at.increment(failure))
      if (at->is_directory(failure)) out.insert(sys::path_text(at->path()));
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
    plan.folders = folders_of(request.paths);
    return plan_shards(std::move(request), count);
  }
  plan.common.push_back(run.pack->batch);
  if (!run.pack->check.config.empty()) plan.common.push_back(run.pack->check.config);
  return plan_batch(*run.pack, count);
}

PlanFiles files_of(const RunPlan& plan, const std::string& format) {
  if (format == "slurm") return slurm_plan(plan);
  if (format == "cuecmd") return cuecmd_plan(plan);
  if (format == "parallel") return parallel_plan(plan);
  return format == "ninja" ? ninja_plan(plan) : json_plan(plan);
}

std::string told(const PlanArguments& a, const RunPlan& plan) {
  const std::string out = shell_word(a.out);
  const bool merges = !plan.merge.words.empty();
  const std::string next = a.format == "slurm"    ? "sh " + out + "/submit.sh"
                           : a.format == "cuecmd" ? "cuecmd " + out + "/tasks.cmds" +
                                                        (merges ? ", then sh " + out + "/merge.sh" : "")
                           : a.format == "parallel" ? "sh " + out + "/run.sh"
                           : a.format == "ninja"    ? "ninja -C " + out
                                                    : out + "/plan.json names the commands";
  return grouped(plan.tasks.size()) + (plan.tasks.size() == 1 ? " task" : " tasks") +
         (merges ? " and a merge that writes " + plan.merge.writes : "") + "; next: " + next;
}

bool has_same_files(const std::string& folder, const PlanFiles& files) {
  return std::ranges::all_of(files, [&](const auto& file) {
    std::error_code failure;
    const std::string path = folder + '/' + file.first;
    return fs::is_regular_file(path, failure) && read_file(path) == file.second;
  });
}

}  // namespace

int plan_run(const PlanArguments& a) {
  const AskedRun run = read_run(a.words);
  RunPlan plan;
  plan.folder = sys::path_text(fs::current_path());
  plan.out = sys::path_text(fs::absolute(a.out).lexically_normal());
  while (plan.out.size() > 1 && plan.out.ends_with('/')) plan.out.pop_back();
  plan.threads = run.threads;
  const bool names_files = a.format == "ninja";
  std::vector<ShardPlan> shards;
  if (names_files)
    shards = planned_shards(run, a.tasks, plan);
  else
    for (std::size_t i = 1; i <= a.tasks; ++i) shards.push_back(ShardPlan{{i, a.tasks, {}}, {}, {}});
  std::vector<std::string> merge{a.program, "merge"};
  for (ShardPlan& shard : shards) {
    PlanTask& task = plan.tasks.emplace_back();
    task.writes = plan.out + "/part-" + std::to_string(shard.shard.index) + ".json";
    task.words = {a.program, run.verb};
    task.words.insert(task.words.end(), run.words.begin(), run.words.end());
    std::string part = shard.shard.text();
    if (shard.shard.items)
      part +=
          ':' + std::to_string(shard.shard.items->first) + '-' + std::to_string(shard.shard.items->second);
    std::vector<std::string> own{"--shard", part, "-q"};
    if (run.pack) {
      own.insert(own.end(), {"--batch-report", task.writes});
      if (!run.form_given) own.insert(own.end(), {"--report", "none"});
    } else {
      own.insert(own.end(), {"--format", "json", "-o", task.writes, "--force"});
    }
    // Options stand before the arguments, so that "--" among those keeps its meaning.
    task.words.insert(task.words.begin() + 2, own.begin(), own.end());
    merge.push_back(task.writes);
    task.plan = std::move(shard);
  }
  if (run.validate) {
    plan.merge.writes = run.result.empty() ? plan.out + "/result." + ending_of(run.format) : run.result;
    merge.insert(merge.end(), {"--format", run.format, "-o", plan.merge.writes, "--force", "-q"});
    if (!run.baseline.empty()) merge.insert(merge.end(), {"--write-baseline", run.baseline});
    plan.merge.words = std::move(merge);
  }
  plan.again = {a.program,   "plan",    "--tasks", std::to_string(a.tasks),
                "--format",  a.format,  "-o",      plan.out,
                "--program", a.program, "--force", "-q",
                "--"};
  plan.again.insert(plan.again.end(), a.words.begin(), a.words.end());
  const PlanFiles files = files_of(plan, a.format);
  // A plan that stays the same is not written again, so that no task runs because of it.
  if (!has_same_files(plan.out, files)) {
    OutputTree folder(a.out, may_replace(a.force));
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
    folder.commit();
  }
  OutputArguments shown;
  shown.quiet = a.quiet;
  remark(shown, told(a, plan));
  return exit_ok;
}

}  // namespace etak::cli
