// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/files/input.h"
#include "core/base/text.h"
#include "core/validate/output/formats.h"

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

std::string grouped(std::size_t value) {
  std::string out = std::to_string(value);
  for (std::size_t at = out.size(); at > 3;) out.insert(at -= 3, 1, ',');
  return out;
}

std::string place_of(const Finding& finding) {
  std::string out = finding.file;
  // A scene's pointer to a material means nothing in the texture that the finding is in. What came from a
  // pipe is the scene itself: its textures are files.
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
  return out;
}

std::string sentence_of(const Finding& finding) {
  std::string out = finding.message;
  while (out.ends_with('.')) out.pop_back();
  if (!finding.cause.empty() && out.find(finding.cause) == out.npos) out += "; " + finding.cause;
  while (out.ends_with('.')) out.pop_back();
  return out;
}

ReportCounts count_files(const ValidationReport& report) {
  ReportCounts out;
  for (const CheckedFile& file : report.files) {
    // The configuration may have findings of its own (ETK903) but was not what was to be checked.
    const bool is_config = !file.roles.empty() && file.roles.front().second == "config";
    const std::size_t members = is_config ? 0 : 1 + file.companions.size();
    out.files += members;
    if (file.unreadable) ++out.unreadable;
    bool clean = !file.unreadable;
    for (const Finding& finding : file.findings) {
      if (finding.suppressed)
        ++out.suppressed;
      else if (finding.baseline)
        ++out.known;
      else
        clean = false;
    }
    if (clean) out.clean += members;
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
  std::string out = report.incomplete ? "INCOMPLETE: " : report.passed ? "PASSED: " : "FAILED: ";
  if (report.incomplete)
    out += files.unreadable > 0 ? counted(files.unreadable, "file") + " could not be checked; "
                                : "not everything could be checked; ";
  if (found.empty())
    out += counted(files.files, "file") + ", 0 findings";
  else
    out +=
        found + " in " + counted(files.files - files.clean, "file") + " (" + grouped(files.clean) + " clean)";
  if (files.suppressed > 0) out += ", " + grouped(files.suppressed) + " allowed";
  if (files.known > 0) out += ", " + grouped(files.known) + " known from the baseline";
  return out + '.';
}

std::string validation_text(const ValidationReport& report, bool color) {
  std::string out;
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings) {
      if (!counts(finding)) continue;
      out += line_text(place_of(finding));
      out += ' ';
      if (color) out += color_of(finding.severity);
      out += name(finding.severity);
      if (color) out += "\x1b[0m";
      out += ' ' + finding.rule + ' ' + finding.slug + ": ";
      out += line_text(sentence_of(finding));
      out += '.';
      if (!finding.fix.empty()) {
        out += " Fix: ";
        out += line_text(finding.fix);
        if (!finding.fix.ends_with('.')) out += '.';
      }
      out += '\n';
    }
  return out + verdict_of(report) + '\n';
}

}  // namespace etak
