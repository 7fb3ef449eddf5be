// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/files/input.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"

namespace etak {
namespace {

std::string counted(std::size_t count, std::string_view one) {
  return grouped(count) + ' ' + std::string(one) + (count == 1 ? "" : "s");
}

std::string_view color_of(Severity severity) {
  if (severity == Severity::error) return "\x1b[1;31m";
  return severity == Severity::warning ? "\x1b[1;33m" : "\x1b[1;36m";
}

}  // namespace

std::string place_of(const Finding& finding) {
  return place_of(finding, finding.file);
}

std::string place_of(const Finding& finding, const std::string& file) {
  std::string out = file;
  // A pointer to a material of a scene means nothing in the texture that the finding is in. A file from a
  // pipe is the scene itself, because its textures are files.
  const bool in_texture = finding.pointer.starts_with("/materials/") && !finding.file.ends_with(".gltf") &&
                          !finding.file.ends_with(".glb") && !is_pipe_input(finding.file);
  if (!finding.pointer.empty() && !in_texture) out += '#' + finding.pointer;
  if (!finding.tile.empty())
    out += ":tile \"" + finding.tile + '"';
  else if (in_texture && !finding.material.empty())
    out += ":material \"" + finding.material + '"';
  if (finding.box)
    out += " [" + std::to_string(finding.box->x) + ',' + std::to_string(finding.box->y) + ' ' +
           std::to_string(finding.box->width) + 'x' + std::to_string(finding.box->height) + ']';
  // For a finding on a page the place in the material's own textures, where it can be mended.
  if (!finding.tile.empty() && finding.uv) {
    const UvBox& uv = *finding.uv;
    out += " (UV " + number(uv[0], 3) + ' ' + number(uv[1], 3) + " to " + number(uv[2], 3) + ' ' +
           number(uv[3], 3) + ')';
  }
  if (!finding.islands.empty()) {
    const std::size_t more = finding.islands.size() - 1;
    out += " and " + grouped(more) + (more == 1 ? " more island" : " more islands");
  }
  return out;
}

std::string sentence_of(const Finding& finding) {
  std::string out = finding.message;
  while (out.ends_with('.')) out.pop_back();
  if (!finding.cause.empty() && out.find(finding.cause) == out.npos) out += "; " + finding.cause;
  while (out.ends_with('.')) out.pop_back();
  return out;
}

Severity worst_of(const CheckedFile& file) {
  Severity worst = Severity::off;
  for (const Finding& finding : file.findings) worst = std::max(worst, weight(finding));
  return worst;
}

std::vector<std::size_t> page_order(const ValidationReport& report) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < report.files.size(); ++i)
    if (!report.files[i].findings.empty()) out.push_back(i);
  std::ranges::stable_sort(out, std::greater{}, [&](std::size_t i) { return worst_of(report.files[i]); });
  return out;
}

ReportCounts count_files(const ValidationReport& report) {
  ReportCounts out;
  for (const CheckedFile& file : report.files) {
    // The configuration may have findings of its own (ETK903), but is none of the files that were to be
    // checked.
    const bool is_config = !file.roles.empty() && file.roles.front().role == "config";
    const std::size_t own = file.is_set ? 0 : 1;
    const std::size_t members = is_config ? 0 : own + file.companions.size();
    out.files += members;
    if (file.unreadable) ++out.unreadable;
    Severity worst = file.unreadable ? Severity::error : Severity::off;
    for (const Finding& finding : file.findings) {
      if (finding.suppressed)
        ++out.suppressed;
      else if (finding.baseline)
        ++out.known;
      else
        worst = std::max(worst, finding.severity);
    }
    if (worst > Severity::off) out.found_in += members;
    if (worst <= Severity::info) out.clean += members;
  }
  return out;
}

std::string verdict_of(const ValidationReport& report) {
  const ReportCounts files = count_files(report);
  std::string found;
  const auto add = [&](std::size_t count, std::string_view word) {
    if (count > 0) found += (found.empty() ? "" : ", ") + counted(count, word);
  };
  add(report.errors, "error");
  add(report.warnings, "warning");
  add(report.infos, "info");
  std::string out = report.shard ? "shard " + report.shard->shard.text() + ": " : "";
  out += report.incomplete ? "INCOMPLETE: " : report.passed ? "PASSED: " : "FAILED: ";
  if (report.nothing_checked)
    out += "nothing was checked; ";
  else if (report.incomplete)
    out += files.unreadable > 0 ? counted(files.unreadable, "file") + " could not be checked; "
                                : "not everything could be checked; ";
  if (found.empty())
    out += counted(files.files, "file") + ", 0 findings";
  else
    out += found + " in " + counted(files.found_in, "file") + " (" + grouped(files.clean) + " clean)";
  if (files.suppressed > 0) out += ", " + grouped(files.suppressed) + " allowed";
  if (files.known > 0) out += ", " + grouped(files.known) + " known from the baseline";
  if (!report.unknown.empty()) out += ", " + counted(report.unknown.size(), "picture") + " not recognised";
  return out + '.';
}

std::string shown_path(const std::string& label, const TypedFolders& typed) {
  for (std::size_t end = label.rfind('/');; end = label.rfind('/', end - 1)) {
    const bool top = end == label.npos;
    const auto found = typed.find(top ? "." : label.substr(0, end));
    if (found != typed.end()) {
      const std::string rest = label.substr(top ? 0 : end + 1);
      if (found->second.empty() || (top && rest.starts_with("../"))) return top ? label : rest;
      return found->second + (found->second.ends_with('/') ? "" : "/") + rest;
    }
    if (top || end == 0) return label;
  }
}

namespace {

void add_severity(std::string& out, Severity severity, bool color) {
  out += ' ';
  if (color) out += color_of(severity);
  out += name(severity);
  if (color) out += "\x1b[0m";
}

void add_sentences(std::string& out, const Finding& finding) {
  out += line_text(sentence_of(finding));
  out += '.';
  if (!finding.fix.empty()) {
    out += " Fix: ";
    out += line_text(finding.fix);
    if (!finding.fix.ends_with('.')) out += '.';
  }
  out += '\n';
}

// The order of findings of one severity.
auto place_key(const Finding& f) {
  return std::tuple(std::string_view(f.file), std::string_view(f.pointer), std::string_view(f.tile),
                    f.box ? f.box->y : -1, f.box ? f.box->x : -1, std::string_view(f.rule));
}

// What was repaired and what was left. Findings below `least` that were left are only counted; those that came
// up after a repair are told in any case.
std::string told_repairs(const ValidationReport& report, Severity least) {
  std::map<std::pair<std::string_view, std::string_view>, Severity> worst;  // by rule and file
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings) {
      Severity& severity = worst.try_emplace({finding.rule, finding.file}, Severity::off).first->second;
      severity = std::max(severity, finding.severity);
    }
  RepairReport told = *report.repairs;
  const std::size_t lower = std::erase_if(told.left, [&](const LeftFinding& left) {
    const auto at = worst.find({left.rule, left.file});
    return at != worst.end() && at->second < least;
  });
  std::string out = repairs_text(told, report.typed);
  if (lower > 0)
    out += counted(lower, "finding") + " below " + std::string(name(least)) +
           " left too; --min-severity info lists " + (lower == 1 ? "it" : "them") + ".\n";
  return out;
}

}  // namespace

std::string validation_text(const ValidationReport& report, const TextOptions& options) {
  if (!options.findings) return verdict_of(report) + '\n';
  std::vector<const Finding*> shown;
  std::map<std::string_view, std::vector<const Finding*>> infos;  // by rule
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings) {
      if (!counts(finding) || finding.severity < options.least) continue;
      if (options.fold_infos && finding.severity == Severity::info)
        infos[finding.rule].push_back(&finding);
      else
        shown.push_back(&finding);
    }
  for (auto& [rule, findings] : infos)
    if (findings.size() == 1) shown.push_back(std::exchange(findings, {}).front());
  std::stable_sort(shown.begin(), shown.end(), [](const Finding* a, const Finding* b) {
    return a->severity != b->severity ? a->severity > b->severity : place_key(*a) < place_key(*b);
  });
  std::string out;
  const auto add_place = [&](const Finding& finding) {
    out += line_text(place_of(finding, shown_path(finding.file, report.typed)));
  };
  for (const Finding* finding : shown) {
    add_place(*finding);
    add_severity(out, finding->severity, options.color);
    out += ' ' + finding->rule + ' ' + finding->slug + ": ";
    add_sentences(out, *finding);
  }
  for (const auto& [rule, findings] : infos) {
    if (findings.empty()) continue;
    std::set<std::string_view> files;
    for (const Finding* finding : findings) files.insert(finding->file);
    const Finding& first = *findings.front();
    add_place(first);
    out += " and " + grouped(findings.size() - 1) + " more";
    if (files.size() > 1) out += " in " + counted(files.size(), "file");
    add_severity(out, Severity::info, options.color);
    out += ' ' + first.rule + ' ' + first.slug + ": ";
    add_sentences(out, first);
  }
  if (report.repairs) out += told_repairs(report, options.least);
  return out + verdict_of(report) + '\n';
}

std::optional<std::string> validation_form(std::string_view form, const ValidationReport& report,
                                           const OutputOptions& options) {
  if (form == "text") return validation_text(report);
  if (form == "json") return validation_json(report, options);
  if (form == "sarif") return validation_sarif(report, options);
  if (form == "junit") return validation_junit(report, options);
  if (form == "github") return validation_github(report);
  if (form == "csv") return validation_csv(report);
  return std::nullopt;
}

}  // namespace etak
