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
#include "core/pages/plan/plan.h"
#include "core/validate/output/formats.h"
#include "core/validate/validate.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

// What is to be run.
//   words      without the options that belong to the output, which the tasks and the merge have of their own
//   format     of the result, and its file; empty: none was asked for
//   validate, pack   the options, of these verbs
struct AskedRun {
  std::string verb, format, result, baseline;
  std::vector<std::string> words;
  bool threads = false, report = false;
  std::shared_ptr<ValidateArguments> validate;
  std::shared_ptr<PackArguments> pack;
};

// Takes an option with its value out of the words: "--format X", "--format=X", "-oX". Returns the value; nullopt
// where it is not there.
std::optional<std::string> taken(std::vector<std::string>& words, const std::vector<std::string>& names) {
  std::optional<std::string> out;
  for (std::size_t i = 0; i < words.size() && words[i] != "--";) {
    const std::string& word = words[i];
    std::size_t count = 0;
    for (const std::string& name : names) {
      const bool is_long = name.starts_with("--");
      if (word == name && i + 1 < words.size()) {
        out = words[i + 1];
        count = 2;
      } else if (is_long ? word.starts_with(name + '=')
                         : word.starts_with(name) && word.size() > name.size()) {
        out = word.substr(name.size() + (is_long ? 1 : 0));
        count = 1;
      }
      if (count > 0) break;
    }
    if (count == 0) {
      ++i;
      continue;
    }
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                words.begin() + static_cast<std::ptrdiff_t>(i + count));
  }
  return out;
}

bool taken_flag(std::vector<std::string>& words, const std::vector<std::string>& names) {
  return std::erase_if(words, [&](const std::string& word) { return std::ranges::count(names, word) > 0; }) >
         0;
}

// Reads the words as the verb itself will, so that a mistake is told now and not by every task.
AskedRun read_run(std::vector<std::string> words) {
  AskedRun out;
  if (words.empty())
    throw Error::at("etak plan", "nothing to run",
                    "-- and a verb with its arguments, such as -- validate textures");
  out.verb = words.front();
  CommandLine line("", "etak");
  if (out.verb == "validate")
    declare_validate(line, out.validate = std::make_shared<ValidateArguments>());
  else if (out.verb == "pack")
    declare_pack(line, out.pack = std::make_shared<PackArguments>());
  else if (out.verb == "f0")
    add_f0(line);
  else if (out.verb == "export")
    add_export(line);
  else
    throw Error::at("etak plan", "the verb " + in_quotes(out.verb),
                    "validate, pack, f0 or export, which have shards");
  std::vector<std::string> with_program = words;
  with_program.insert(with_program.begin(), "etak");
  (void)line.read(with_program);
  words.erase(words.begin());
  if (taken(words, {"--shard"})) throw Error::at("--shard", "in the run of a plan", "the run without it");
  out.threads = std::ranges::any_of(words, [](const std::string& word) {
    return word.starts_with("-j") || word.starts_with("--threads") || word.starts_with("--jobs");
  });
  if (out.pack) {
    if (out.pack->batch.empty()) throw Error::at("etak plan", "etak pack without --batch", "--batch FILE");
    out.result = taken(words, {"--batch-report"}).value_or("");
    out.format = "json";
    out.report =
        std::ranges::any_of(words, [](const std::string& word) { return word.starts_with("--report"); });
  } else {
    const auto format = taken(words, {"--format"}), result = taken(words, {"-o", "--output"});
    out.result = result.value_or("");
    out.format = format.value_or("");
    if (out.validate) {
      out.baseline = taken(words, {"--write-baseline"}).value_or("");
      const std::vector<std::string>& paths = out.validate->paths;
      (void)validate_config(out.validate->settings, paths.empty() ? "" : paths.front(),
                            asked_materials(out.validate->library));
      // The form that the ending of -o tells is settled by now.
      out.format = format || result ? out.validate->output.format : "json";
      if (!out.validate->fix_folder.empty() || !out.validate->mask_folder.empty() ||
          out.validate->list_files || out.validate->list_rules)
        throw Error::at("etak plan", "--fix, --mask, --list-files or --list-rules in the run",
                        "a run that can be cut into shards");
    } else if (out.format.empty()) {
      out.format = out.result.ends_with(".csv") ? "csv" : out.result.ends_with(".jsonl") ? "jsonl" : "json";
    }
    taken_flag(words, {"--force"});
  }
  taken_flag(words, {"-q", "--quiet"});
  out.words = std::move(words);
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
  if (run.pack) {
    plan.common.push_back(run.pack->batch);
    if (!run.pack->check.config.empty()) plan.common.push_back(run.pack->check.config);
    return plan_batch(*run.pack, count);
  }
  throw Error::at("--format", "ninja of etak " + run.verb + ", whose tasks take milliseconds",
                  "slurm, cuecmd, parallel or json");
}

PlanFiles files_of(const RunPlan& plan, const std::string& format) {
  if (format == "slurm") return slurm_plan(plan);
  if (format == "cuecmd") return cuecmd_plan(plan);
  if (format == "parallel") return parallel_plan(plan);
  return format == "ninja" ? ninja_plan(plan) : json_plan(plan);
}

std::string told(const PlanArguments& a, const RunPlan& plan) {
  const std::string out = shell_word(a.out);
  const std::string next = a.format == "slurm" ? "sh " + out + "/submit.sh"
                           : a.format == "cuecmd"
                               ? "cuecmd " + out + "/tasks.cmds, then sh " + out + "/merge.sh"
                           : a.format == "parallel" ? "sh " + out + "/run.sh"
                           : a.format == "ninja"    ? "ninja -C " + out
                                                    : out + "/plan.json names the commands";
  return grouped(plan.tasks.size()) + (plan.tasks.size() == 1 ? " task" : " tasks") +
         " and a merge that writes " + plan.merge.writes + "; next: " + next;
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
    for (std::size_t i = 1; i <= a.tasks; ++i) shards.push_back(ShardPlan{{i, a.tasks, {}}, {}, 0, {}});
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
      if (!run.report) own.insert(own.end(), {"--report", "none"});
    } else {
      own.insert(own.end(), {"--format", "json", "-o", task.writes, "--force"});
    }
    // Options stand before the arguments, so that "--" among those keeps its meaning.
    task.words.insert(task.words.begin() + 2, own.begin(), own.end());
    merge.push_back(task.writes);
    task.plan = std::move(shard);
  }
  plan.merge.writes = run.result.empty() ? plan.out + "/result." + ending_of(run.format) : run.result;
  merge.insert(merge.end(), {"--format", run.format, "-o", plan.merge.writes, "--force", "-q"});
  if (!run.baseline.empty()) merge.insert(merge.end(), {"--write-baseline", run.baseline});
  plan.merge.words = std::move(merge);
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
