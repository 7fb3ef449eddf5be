// SPDX-License-Identifier: Apache-2.0
#include "core/findings/suppress.h"

#include <algorithm>
#include <vector>

#include "core/judge/rules.h"

namespace etak {
namespace {

// Where the pattern does not fit on, the latest '*' takes one more character, else the latest "**". Only the
// latest star of each kind is remembered, which bounds the number of steps.
bool glob_part(std::string_view pattern, std::string_view path) {
  std::size_t p = 0, s = 0;
  std::size_t star = std::string_view::npos, star_at = 0;
  std::size_t deep = std::string_view::npos, deep_at = 0;
  while (s < path.size() || p < pattern.size()) {
    if (p < pattern.size() && pattern.substr(p).starts_with("**")) {
      deep = p;
      deep_at = s;
      star = std::string_view::npos;
      p += 2;
      // "**/" also stands for no folder at all.
      if (p < pattern.size() && pattern[p] == '/' && (s == 0 || path[s - 1] == '/')) ++p;
      continue;
    }
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_at = s;
      continue;
    }
    if (p < pattern.size() && s < path.size() &&
        (pattern[p] == path[s] || (pattern[p] == '?' && path[s] != '/'))) {
      ++p;
      ++s;
      continue;
    }
    if (star != std::string_view::npos && star_at < path.size() && path[star_at] != '/') {
      p = star + 1;
      s = ++star_at;
      continue;
    }
    if (deep != std::string_view::npos && deep_at < path.size()) {
      star = std::string_view::npos;
      s = ++deep_at;
      p = deep + 2;
      if (p < pattern.size() && pattern[p] == '/' && path[s - 1] == '/') ++p;
      continue;
    }
    return false;
  }
  return true;
}

bool covers(const AllowEntry& entry, const Finding& finding) {
  return finding.rule.starts_with(entry.rule) && !is_of_the_tool(finding.rule) &&
         (entry.file.empty() || glob_matches(entry.file, finding.file)) &&
         (entry.tile.empty() || glob_part(entry.tile, finding.tile)) &&
         (entry.material.empty() || glob_part(entry.material, finding.material));
}

bool concerns(const AllowEntry& entry, const CheckedFile& file) {
  if (entry.file.empty() || glob_matches(entry.file, file.path)) return true;
  return std::any_of(file.companions.begin(), file.companions.end(),
                     [&](const std::string& path) { return glob_matches(entry.file, path); });
}

Finding unused_finding(const AllowEntry& entry, std::size_t index, const AllowanceRun& run, bool expired) {
  Finding out = finding_of(*find_rule("ETK903"), run.unused);
  out.file = run.config;
  out.pointer = "/allow/" + std::to_string(index);
  out.value = entry.rule;
  const std::string what =
      "the [[allow]] entry of " + entry.rule + (entry.file.empty() ? "" : " in \"" + entry.file + "\"");
  if (expired) {
    out.message = what + " ended on " + entry.expires + " and suppresses nothing any more";
    out.limit = "before " + entry.expires;
    out.fix = "mend the asset, or look at it again and set a later date";
  } else {
    out.message = what + " suppresses nothing";
    out.limit = "at least one finding";
    out.fix = "remove the entry";
  }
  return out;
}

}  // namespace

bool glob_matches(std::string_view pattern, std::string_view path) {
  if (pattern.find('/') == std::string_view::npos)
    if (const auto slash = path.rfind('/'); slash != std::string_view::npos) path.remove_prefix(slash + 1);
  return glob_part(pattern, path);
}

bool is_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const auto part = [&](std::size_t from, std::size_t count) {
    int value = 0;
    for (const char c : text.substr(from, count)) {
      if (c < '0' || c > '9') return -1;
      value = value * 10 + (c - '0');
    }
    return value;
  };
  const int year = part(0, 4), month = part(5, 2), day = part(8, 2);
  if (year < 0 || month < 1 || month > 12 || day < 1) return false;
  constexpr int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return day <= days[month - 1] + (month == 2 && leap ? 1 : 0);
}

std::vector<AllowanceUse> mark_allowed(ValidationReport& report, std::span<const AllowEntry> entries,
                                       const AllowanceRun& run) {
  std::vector<AllowanceUse> out(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const AllowEntry& entry = entries[i];
    const bool expired = !entry.expires.empty() && run.today >= entry.expires;
    out[i].anyhow = run.whole_tree;
    if (run.unused != Severity::off && (expired || !run.is_active || run.is_active(entry.rule)))
      out[i].unused = unused_finding(entry, i, run, expired);
    for (CheckedFile& file : report.files) {
      if (!concerns(entry, file)) continue;
      out[i].met = true;
      if (expired) continue;
      for (Finding& finding : file.findings) {
        if (!covers(entry, finding)) continue;
        out[i].used = true;
        // The first entry gives the reason; a later one that covers the same finding counts as used as well.
        if (!finding.suppressed) finding.suppression = entry.reason;
        finding.suppressed = true;
      }
    }
  }
  return out;
}

void add_unused_allowances(ValidationReport& report, std::span<const AllowanceUse> uses) {
  CheckedFile config;
  for (const AllowanceUse& use : uses)
    if (use.unused && !use.used && (use.met || use.anyhow)) config.findings.push_back(*use.unused);
  if (config.findings.empty()) return;
  config.path = config.findings.front().file;
  config.roles = {{config.path, "config"}};
  const auto place =
      std::lower_bound(report.files.begin(), report.files.end(), config.path,
                       [](const CheckedFile& file, const std::string& path) { return file.path < path; });
  report.files.insert(place, std::move(config));
}

void apply_allowances(ValidationReport& report, std::span<const AllowEntry> entries,
                      const AllowanceRun& run) {
  add_unused_allowances(report, mark_allowed(report, entries, run));
}

}  // namespace etak
