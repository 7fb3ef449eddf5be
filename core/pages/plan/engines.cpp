// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/pages/plan/plan.h"

namespace etak {
namespace {

std::string shell_line(const std::vector<std::string>& words) {
  return joined(words, " ", shell_word);
}

// Whether a task has succeeded is told by its output, because the status of a run with findings is that of a
// failure. The output is therefore written under a new name and put in its place in one step: an older one
// proves nothing, and must not be missing while the merge reads it because the task runs twice.
constexpr std::string_view new_name = "new=$part.$(hostname).$$";
constexpr std::string_view put_in_place = "test -e \"$new\" && mv -f \"$new\" \"$part\"";

// Where no merge follows that tells the status of the run, a task that has failed is one for its engine too.
std::string_view end_of_task(const RunPlan& plan) {
  return plan.merge.words.empty()
             ? "if [ $? -le 1 ]; then mv -f \"$new\" \"$part\"; else rm -f \"$new\"; false; fi"
             : put_in_place;
}

// The words of a task that writes to $new.
std::string task_words(const PlanTask& task) {
  return joined(task.words, " ", [&](const std::string& word) {
    return word == task.writes ? std::string("\"$new\"") : shell_word(word);
  });
}

// A task in one line.
std::string task_line(const RunPlan& plan, const PlanTask& task) {
  std::string out = "cd " + shell_word(plan.folder) + " && part=" + shell_word(task.writes) + " && ";
  append(out, new_name, " && { ", task_words(task), "; ", end_of_task(plan), "; }");
  return out;
}

void refuse_in(const std::vector<std::string>& words, std::string_view characters, const std::string& found) {
  for (const std::string& word : words)
    if (word.find_first_of(characters) != word.npos)
      throw Error::at(printable(word, 200), found, "another name, or " + setting("format") + " slurm");
}

void refuse_line_ends(const std::vector<std::string>& words, const char* engine) {
  refuse_in(words, "\r\n",
            std::string("a line end in a name, which ") + engine + " takes for the end of a command");
}

void refuse_line_ends(const RunPlan& plan, const char* engine) {
  refuse_line_ends(std::vector{plan.folder, plan.out}, engine);
  for (const PlanTask& task : plan.tasks) refuse_line_ends(task.words, engine);
  refuse_line_ends(plan.merge.words, engine);
}

// Some engines read their files as UTF-8.
void refuse_other_text(const RunPlan& plan, const char* engine) {
  const auto check = [&](const std::vector<std::string>& words) {
    for (const std::string& word : words)
      if (valid_utf8(word) != word)
        throw Error::at(printable(word, 200),
                        std::string("a name that is no UTF-8, as ") + engine + " needs it",
                        "another name, or " + setting("format") + " slurm");
  };
  check({plan.folder, plan.out});
  for (const PlanTask& task : plan.tasks) {
    check(task.words);
    check(task.plan.files);
  }
  check(plan.merge.words);
}

// The files of a plan with the script of its merge, where it has one.
PlanFiles with_merge(const RunPlan& plan, PlanFiles files) {
  if (!plan.merge.words.empty())
    files.emplace_back(
        "merge.sh", "#!/bin/sh\n# Joins what the tasks wrote. Its status is that of the whole run.\ncd " +
                        shell_word(plan.folder) + " || exit 2\nexec " + shell_line(plan.merge.words) + '\n');
  return files;
}

std::string task_lines(const RunPlan& plan) {
  std::string out;
  for (const PlanTask& task : plan.tasks) out += task_line(plan, task) + '\n';
  return out;
}

}  // namespace

std::string shell_word(std::string_view word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return std::string(word);
  std::string out = "'";
  for (const char c : word) c == '\'' ? out += "'\\''" : out += c;
  return out + '\'';
}

PlanFiles slurm_plan(const RunPlan& plan) {
  std::string cases;
  const std::size_t count = plan.tasks.size();
  for (std::size_t i = 0; i < count; ++i) {
    const PlanTask& task = plan.tasks[i];
    append(cases, "  ", std::to_string(i + 1), ")\n    part=", shell_word(task.writes), "\n    ", new_name,
           "\n    set -- ", task_words(task), " ;;\n");
  }
  std::string tasks =
      "#!/bin/sh\n# A task of the array: the shard of its number. It may run again at any time.\ncd " +
      shell_word(plan.folder) + " || exit 2\ncase $SLURM_ARRAY_TASK_ID in\n" + cases +
      "  *) echo \"no task $SLURM_ARRAY_TASK_ID in this plan\" >&2; exit 2 ;;\nesac\n";
  if (!plan.threads)
    tasks += "if [ -n \"${SLURM_CPUS_PER_TASK:-}\" ]; then set -- \"$@\" -j \"$SLURM_CPUS_PER_TASK\"; fi\n";
  append(tasks,
         "# The status of a run with findings is that of a failure for Slurm.\n"
         "\"$@\"\nstatus=$?\n(exit $status)\n",
         end_of_task(plan), " && exit 0\n[ \"$status\" -gt 1 ] || status=2\nexit \"$status\"\n");
  // Slurm replaces what follows a '%' in the names of logs.
  std::string logs = plan.out + '/';
  for (std::size_t at = 0; (at = logs.find('%', at)) != logs.npos; at += 2) logs.insert(at, 1, '%');
  const std::string folder = shell_word(plan.out + '/');
  std::string submit =
      "#!/bin/sh\n# submit.sh [OPTIONS OF SBATCH...]: starts the array, and the merge behind it. Prints the "
      "number of the last job.\nset -eu\narray=$(sbatch --parsable --job-name=etak --requeue --array=1-" +
      std::to_string(count) + " --output=" + shell_word(logs + "task-%a.log") + " \"$@\" " + folder +
      "task.sh)\n";
  submit += plan.merge.words.empty()
                ? "echo \"$array\"\n"
                : "sbatch --parsable --job-name=etak-merge --requeue --dependency=afterok:\"${array%%;*}\" "
                  "--kill-on-invalid-dep=yes --output=" +
                      shell_word(logs + "merge.log") + " \"$@\" " + folder + "merge.sh\n";
  return with_merge(plan, {{"task.sh", tasks}, {"submit.sh", submit}});
}

PlanFiles cuecmd_plan(const RunPlan& plan) {
  refuse_line_ends(plan, "cuecmd");
  refuse_other_text(plan, "cuecmd");
  return with_merge(plan, {{"tasks.cmds", task_lines(plan)}});
}

PlanFiles parallel_plan(const RunPlan& plan) {
  refuse_line_ends(plan, "GNU parallel");
  const std::string folder = shell_word(plan.out + '/');
  const std::string merge = plan.merge.words.empty() ? "" : "exec sh " + folder + "merge.sh\n";
  return with_merge(
      plan, {{"tasks.txt", task_lines(plan)},
             {"run.sh",
              "#!/bin/sh\n# run.sh [OPTIONS OF PARALLEL...]: runs all tasks, and then the merge.\nset -eu\n"
              "parallel --will-cite --halt soon,fail=1 \"$@\" <" +
                  folder + "tasks.txt\n" + merge}});
}

namespace {

// A text in the value of a variable.
std::string ninja_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '$') out += '$';
    out += c;
  }
  return out;
}

// A path in a line of inputs and outputs.
std::string ninja_path(std::string_view path) {
  std::string out;
  for (const char c : path) {
    if (c == '$' || c == ' ' || c == ':') out += '$';
    out += c;
  }
  return out;
}

}  // namespace

PlanFiles ninja_plan(const RunPlan& plan) {
  constexpr const char* engine = "ninja";
  refuse_line_ends(plan, engine);
  refuse_line_ends(plan.common, engine);
  refuse_line_ends(plan.folders, engine);
  const auto absolute = [&](const std::string& path) {
    const std::string whole = path.starts_with('/') ? path : plan.folder + '/' + path;
    refuse_in({whole}, "|", "a | in a name, which ninja has no way to write");
    return ninja_path(whole);
  };
  std::string out =
      "# A run of etak in shards. A task runs again where its files or options have changed.\n"
      "ninja_required_version = 1.5\nbuilddir = " +
      ninja_text(plan.out) +
      "\nrule run\n  command = $line\n  description = $what\n"
      "rule plan\n  command = $line\n  description = making the plan again\n  generator = 1\n  restat = 1\n";
  for (const PlanTask& task : plan.tasks) {
    refuse_line_ends(task.plan.files, engine);
    append(out, "build ", absolute(task.writes), ": run");
    if (!task.plan.files.empty() || !plan.common.empty()) out += " |";
    for (const auto* const files : {&task.plan.files, &plan.common})
      for (const std::string& file : *files) append(out, " $\n    ", absolute(file));
    append(out, "\n  line = ", ninja_text(task_line(plan, task)), " # files ", task.plan.list,
           "\n  what = shard ", task.plan.shard.text(), '\n');
  }
  std::string parts;
  for (const PlanTask& task : plan.tasks) append(parts, " $\n    ", absolute(task.writes));
  const bool merges = !plan.merge.words.empty();
  if (merges)
    append(out, "build ", absolute(plan.merge.writes), ": run |", parts, "\n  line = cd ",
           ninja_text(shell_word(plan.folder)), " && ", ninja_text(shell_line(plan.merge.words)),
           "\n  what = merge\n");
  // ninja runs in the folder of the plan: its own file has to be named as ninja opens it.
  out += "build build.ninja: plan |";
  for (const auto* const files : {&plan.folders, &plan.common})
    for (const std::string& file : *files) append(out, " $\n    ", absolute(file));
  append(out, "\n  line = cd ", ninja_text(shell_word(plan.folder)), " && ",
         ninja_text(shell_line(plan.again)), '\n');
  append(out, "default ", merges ? absolute(plan.merge.writes) : parts, '\n');
  return {{"build.ninja", out}};
}

PlanFiles json_plan(const RunPlan& plan) {
  refuse_other_text(plan, "JSON");
  const auto task_json = [](const PlanTask& task) {
    return json_object({{"shard", json(task.plan.shard.text())},
                        {"words", json_array_of(task.words)},
                        {"writes", json(task.writes)}},
                       4);
  };
  const std::string merge =
      json_object({{"words", json_array_of(plan.merge.words)}, {"writes", json(plan.merge.writes)}}, 2);
  return {{"plan.json", json_document("etak-plan/1", {{"folder", json(plan.folder)},
                                                      {"common", json_array_of(plan.common)},
                                                      {"merge", plan.merge.words.empty() ? "null" : merge},
                                                      {"tasks", json_lines_of(plan.tasks, 2, task_json)}})}};
}

}  // namespace etak
