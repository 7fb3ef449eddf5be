// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>
#include <string_view>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"

namespace etak {
namespace {

// The copy as the user would type it.
std::string copy_path(const RepairReport& repairs, const RepairedFile& file) {
  return repairs.folder + (repairs.folder.ends_with('/') ? "" : "/") + file.copy;
}

void add_repaired(std::string& out, const RepairReport& repairs, const RepairedFile& file) {
  out += line_text(copy_path(repairs, file)) + " fixed";
  for (const RepairStep& step : file.steps) {
    out += std::string(&step == &file.steps.front() ? " " : "; ") + step.rule;
    for (const std::string& rule : step.also) out += " and " + rule;
    out += ": " + line_text(step.what) + " (" + grouped(step.texels) + " texels)";
  }
  out += "; " + grouped(file.of - file.texels) + " of " + grouped(file.of) + " texels are as they were";
  for (const std::string& lost : file.not_kept)
    out += (&lost == &file.not_kept.front() ? "; not kept: " : ", ") + line_text(lost);
  out += ".\n";
}

}  // namespace

std::string repairs_text(const RepairReport& repairs, const TypedFolders& typed) {
  std::string out;
  std::size_t copies = 0;
  for (const RepairedFile& file : repairs.files)
    if (file.steps.empty())
      ++copies;
    else
      add_repaired(out, repairs, file);
  if (copies > 0)
    out += line_text(repairs.folder) + " holds " + grouped(copies) +
           (copies == 1 ? " more file of these sets, copied" : " more files of these sets, copied") +
           " byte for byte.\n";
  // Reasons that hold for several rules and files are told once.
  std::map<std::string_view, std::vector<const LeftFinding*>> reasons;
  for (const LeftFinding& left : repairs.left) reasons[left.why].push_back(&left);
  for (const auto& [why, all] : reasons) {
    std::set<std::string_view> rules;
    for (const LeftFinding* left : all) rules.insert(left->rule);
    out += line_text(shown_path(all.front()->file, typed));
    if (all.size() > 1) out += " and " + grouped(all.size() - 1) + " more";
    out += " left";
    for (const std::string_view rule : rules)
      out += std::string(rule == *rules.begin() ? " " : ", ") + std::string(rule);
    out += ": " + line_text(why) + ".\n";
  }
  return out;
}

}  // namespace etak
