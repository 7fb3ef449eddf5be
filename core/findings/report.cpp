// SPDX-License-Identifier: Apache-2.0
#include "core/findings/report.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <map>

#include "core/base/system.h"
#include "core/base/text/text.h"
#include "core/findings/baseline.h"
#include "core/findings/shards/report_shard.h"
#include "core/findings/suppress.h"
#include "core/judge/rules.h"

namespace etak {
namespace {

void judge_allowances(ValidationReport& report, const Settings& settings, const ReportRun& run) {
  if (settings.allow.empty()) return;
  const auto is_active = [&](std::string_view prefix) {
    const auto meant = rules_with_prefix(prefix);
    return std::any_of(meant.begin(), meant.end(),
                       [&](const Rule* rule) { return severity_of(*rule, settings) != Severity::off; });
  };
  const std::string today = run.today.empty() ? today_here() : run.today;
  const std::string label = sys::path_text(std::filesystem::path(run.config).filename());
  std::vector<AllowanceUse> uses =
      mark_allowed(report, settings.allow,
                   {today, label, severity_of(*find_rule("ETK903"), settings), run.whole_tree, is_active});
  // An allowance that one shard does not use may be used by another.
  if (run.shard != nullptr)
    run.shard->allowances = std::move(uses);
  else
    add_unused_allowances(report, uses);
}

// The files in the order of a report, of which nothing is counted yet.
ValidationReport report_in_order(std::vector<CheckedFile> files, const Settings& settings) {
  ValidationReport report;
  report.profile = name(settings.profile);
  report.transfer = name(settings.transfer);
  report.files = std::move(files);
  // They mostly are in order, because targets are.
  const auto in_order = [](const CheckedFile& a, const CheckedFile& b) { return a.path < b.path; };
  if (!std::is_sorted(report.files.begin(), report.files.end(), in_order))
    std::stable_sort(report.files.begin(), report.files.end(), in_order);
  return report;
}

}  // namespace

std::string today_here() {
  const std::tm parts = sys::local_time(std::time(nullptr));
  std::array<char, 16> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

ValidationReport report_of(std::vector<CheckedFile> files, const Settings& settings) {
  ValidationReport report = report_in_order(std::move(files), settings);
  std::size_t failing = 0;
  for (const CheckedFile& file : report.files) {
    report.incomplete = report.incomplete || file.unreadable;
    for (const Finding& finding : file.findings) {
      if (finding.suppressed || finding.baseline) continue;
      report.errors += finding.severity == Severity::error;
      report.warnings += finding.severity == Severity::warning;
      report.infos += finding.severity == Severity::info;
      failing += finding.severity != Severity::off && finding.severity >= settings.fail_on;
    }
  }
  report.passed = failing == 0 && !report.incomplete;
  return report;
}

void tell_sets_apart(ValidationReport& report) {
  std::map<std::string, std::vector<std::pair<Finding*, const std::string*>>> alike;
  for (CheckedFile& set : report.files)
    for (Finding& finding : set.findings)
      if (!finding.file.empty() && finding.file != set.path)
        alike[joined(std::array{finding.file, finding.rule, finding.tile, finding.message}, "\n")].push_back(
            {&finding, &set.path});
  for (const auto& [text, told] : alike)
    for (const auto& [finding, set] : told)
      if (*told.front().second != *told.back().second) finding->message += ", in the set of " + *set;
}

ValidationReport report_of_run(std::vector<CheckedFile> files, const Settings& settings,
                               const ReportRun& run) {
  ValidationReport out = report_in_order(std::move(files), settings);
  judge_allowances(out, settings, run);
  if (run.renew_known)
    mark_known(out, baseline_of(out));
  else
    mark_known(out, run.known);
  out = report_of(std::move(out.files), settings);
  if (run.shard == nullptr) tell_sets_apart(out);
  out.settings_hash = settings_hash(settings);
  return out;
}

}  // namespace etak
