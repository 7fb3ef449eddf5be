// SPDX-License-Identifier: Apache-2.0
#include "app/cli/plan/engines.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

using Words = std::vector<std::string>;

constexpr std::pair<std::string_view, std::string_view> templates[] = {
#include "plan_templates.inc"
};

std::string_view template_of(std::string_view engine) {
  const auto* const found =
      std::ranges::find(templates, engine, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(templates) ? std::string_view() : found->second;
}

// What follows a directive such as %about in a template; empty where it has none.
std::string_view said_by(std::string_view text, std::string_view directive) {
  const std::size_t at = text.find(directive);
  if (at == text.npos) return {};
  const std::size_t begin = at + directive.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::string with_before(std::string_view text, char before, std::string_view characters) {
  std::string out;
  for (const char c : text) {
    if (characters.find(c) != characters.npos) out += before;
    out += c;
  }
  return out;
}

// A word for a POSIX shell.
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

[[noreturn]] void refuse(std::string_view name, const std::string& found) {
  throw Error::at(printable(name, 200), found, "another name, or --format slurm");
}

std::string quoted(const std::string& word, const std::string& quoting, const RunPlan& plan) {
  if (quoting == "shell") return shell_word(word);
  if (quoting == "dollar") return with_before(word, '$', "$");
  if (quoting == "percent") return with_before(word, '%', "%");
  const std::string whole = word.starts_with('/') ? word : plan.folder + '/' + word;
  if (whole.find('|') != whole.npos) refuse(whole, "a | in a name, which ninja has no way to write");
  return with_before(whole, '$', "$ :");
}

// Whether a task has succeeded is told by its output, because the status of a run with findings is that of a
// failure. The output is therefore written under a new name and put in its place in one step: an older one
// proves nothing, and must not be missing while the merge reads it because the task runs twice. Where no merge
// follows that tells the status of the run, a task that has failed is one for its engine too.
std::string task_line(const RunPlan& plan, const PlanTask& task, std::string_view threads) {
  std::string out = "cd " + shell_word(plan.folder) + " && part=" + shell_word(task.writes) +
                    " && new=$part.$(hostname).$$ && {";
  for (std::size_t i = 0; i < task.words.size(); ++i) {
    out += ' ' + (task.words[i] == task.writes ? "\"$new\"" : shell_word(task.words[i]));
    if (i == 1 && !plan.threads && !threads.empty()) append(out, " ", threads);
  }
  return out +
         (plan.merge.words.empty()
              ? "; s=$?; if [ $s -le 1 ]; then mv -f \"$new\" \"$part\"; else rm -f \"$new\"; (exit $s); fi; }"
              : "; test -e \"$new\" && mv -f \"$new\" \"$part\"; }");
}

// Throws Error for a name that an engine has no way to write.
void check_names(const RunPlan& plan, std::string_view engine, std::string_view needs) {
  const bool lines = needs.find("lines") != needs.npos, utf8 = needs.find("utf-8") != needs.npos;
  const auto check = [&](const Words& words) {
    for (const std::string& word : words) {
      if (lines && word.find_first_of("\r\n") != word.npos)
        refuse(word,
               "a line end in a name, which " + std::string(engine) + " takes for the end of a command");
      if (utf8 && valid_utf8(word) != word)
        refuse(word, "a name that is no UTF-8, as " + std::string(engine) + " needs it");
    }
  };
  check({plan.folder, plan.out});
  for (const PlanTask& task : plan.tasks) {
    check(task.words);
    check(task.plan.files);
  }
  for (const Words* words : {&plan.merge.words, &plan.common, &plan.folders}) check(*words);
}

// A template on its way through a plan.
class Filling {
 public:
  Filling(std::string_view text, const RunPlan& plan) : plan_(plan), threads_(said_by(text, "%threads ")) {
    Words parts;
    for (const PlanTask& task : plan.tasks) parts.push_back(task.writes);
    values_ = {{"folder", {plan.folder}},
               {"out", {plan.out}},
               {"typed", {plan.typed}},
               {"merge", plan.merge.words},
               {"result", {plan.merge.writes}},
               {"common", plan.common},
               {"folders", plan.folders},
               {"again", plan.again},
               {"count", {std::to_string(plan.tasks.size())}},
               {"parts", parts}};
    fill(text);
  }
  EnginePlan out;

 private:
  // Fills the lines of a part of the template, whose blocks begin and end in it.
  void fill(std::string_view text) {
    bool shown = true;
    while (!text.empty()) {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      if (line == "%if merge" || line == "%else")
        shown = line == "%else" ? !shown : !plan_.merge.words.empty();
      else if (line == "%end")
        shown = true;
      else if (!shown)
        continue;
      else if (line == "%each task")
        each_task(text);
      else if (line.starts_with("%next "))
        out.next = filled(line.substr(6));
      else if (line.starts_with("%file "))
        out.files.emplace_back(line.substr(6), "");
      else if (!line.starts_with('%'))
        out.files.back().second += filled(line) + '\n';
    }
  }

  void each_task(std::string_view& text) {
    const std::string_view lines = text.substr(0, text.find("%end\n"));
    text.remove_prefix(lines.size());
    for (const PlanTask& task : plan_.tasks) {
      values_["task"] = {task_line(plan_, task, threads_)};
      values_["index"] = {std::to_string(task.plan.shard.index)};
      values_["shard"] = {task.plan.shard.text()};
      values_["writes"] = {task.writes};
      values_["files"] = task.plan.files;
      values_["list"] = {task.plan.list};
      fill(lines);
    }
  }

  std::string filled(std::string_view line) const {
    std::string text;
    for (std::size_t at = 0; (at = line.find("@{")) != line.npos;) {
      text += line.substr(0, at);
      Words asked = parts_of(line.substr(at + 2, line.find('}', at) - at - 2), ' ');
      Words words = values_.at(asked.front());
      for (std::string& word : words)
        for (std::size_t i = 1; i < asked.size(); ++i) word = quoted(word, asked[i], plan_);
      text += joined(words, " ");
      line.remove_prefix(line.find('}', at) + 1);
    }
    return text.append(line);
  }

  const RunPlan& plan_;
  std::string_view threads_;
  std::map<std::string, Words> values_;
};

EnginePlan json_plan(const RunPlan& plan) {
  check_names(plan, "JSON", "utf-8");
  const auto task_json = [](const PlanTask& task) {
    return json_object({{"shard", json(task.plan.shard.text())},
                        {"words", json_array_of(task.words)},
                        {"writes", json(task.writes)}},
                       4);
  };
  const std::string merge =
      json_object({{"words", json_array_of(plan.merge.words)}, {"writes", json(plan.merge.writes)}}, 2);
  const std::string text = json_document("etak-plan/1", {{"folder", json(plan.folder)},
                                                         {"common", json_array_of(plan.common)},
                                                         {"merge", plan.merge.words.empty() ? "null" : merge},
                                                         {"tasks", json_lines_of(plan.tasks, 2, task_json)}});
  return {{{"plan.json", text}}, shell_word(plan.typed) + "/plan.json names the commands"};
}

}  // namespace

std::vector<std::string> plan_engines() {
  std::vector<std::string> out;
  for (const auto& [name, text] : templates) out.emplace_back(name);
  out.emplace_back("json");
  return out;
}

std::string plan_engines_text() {
  std::string out;
  for (const auto& [name, text] : templates) append(out, name, " (", said_by(text, "%about "), "), ");
  return out + "json";
}

bool names_files(const std::string& engine) {
  return template_of(engine).find("@{files ") != std::string_view::npos;
}

EnginePlan engine_plan(const std::string& engine, const RunPlan& plan) {
  if (engine == "json") return json_plan(plan);
  const std::string_view text = template_of(engine);
  check_names(plan, engine, said_by(text, "%needs "));
  return std::move(Filling(text, plan).out);
}

}  // namespace etak::cli
