// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/findings/report.h"

namespace etak {

// The forms of a validation report. All are made from the report's values alone, in its order, without a
// clock or absolute paths, so that equal reports give equal bytes. Findings that an [[allow]] entry or the
// baseline took out of the verdict are left out of text and GitHub's commands, and marked in the other forms.

/// What a form needs besides the report.
///   fail_on   findings of this severity and above make the verdict FAILED (a failure in JUnit)
///   version   of etak
struct OutputOptions {
  Severity fail_on = Severity::error;
  std::string version;
};

/// Whether the finding takes part in the verdict: neither suppressed nor in the baseline.
inline bool counts(const Finding& finding) {
  return !finding.suppressed && !finding.baseline;
}

/// Numbers of files and findings for the verdict.
struct ReportCounts {
  std::size_t files = 0;
  std::size_t found_in = 0;  // files that have findings that count, or are not readable
  std::size_t clean = 0;     // files that are readable and have no error or warning that counts
  std::size_t unreadable = 0;
  std::size_t suppressed = 0, known = 0;
};
ReportCounts count_files(const ValidationReport& report);

/// How much a finding weighs: its severity, or nothing where it is allowed or known.
inline Severity weight(const Finding& finding) {
  return counts(finding) ? finding.severity : Severity::off;
}

/// Indices of the files with findings as a page shows them: those with the worst findings first, otherwise as
/// in the report. Findings that are allowed or known come last.
std::vector<std::size_t> page_order(const ValidationReport& report);

/// The severity of the worst finding of a file that counts; off: there is none.
Severity worst_of(const CheckedFile& file);

/// Where a finding lies: `crate_spec.png:tile "hinge" [812,64 96x40]`, `wood.json#/datasets/0/n`.
std::string place_of(const Finding& finding);
/// The place of a finding with `file` as the name of the file.
std::string place_of(const Finding& finding, const std::string& file);

/// The message of a finding with its cause, on one line without a full stop at its end.
std::string sentence_of(const Finding& finding);

/// One line: "FAILED: 1 error, 2 warnings in 3 files (41 clean)." or "PASSED: 44 files, 0 findings."; what
/// could not be checked comes first: "INCOMPLETE: 1 of 44 files could not be checked; ...".
std::string verdict_of(const ValidationReport& report);

/// How much of a report the text form shows.
///   color        severity words in ANSI colours
///   least        findings of a lower severity are left out; the verdict still counts them
///   fold_infos   infos of one rule share a line
///   findings     false: the verdict alone
struct TextOptions {
  bool color = false;
  Severity least = Severity::info;
  bool fold_infos = true;
  bool findings = true;
};

/// One line per finding, errors first, those of one severity in the order of places; then what was repaired,
/// if that was asked for; the verdict last. Files are named as the user named them.
std::string validation_text(const ValidationReport& report, const TextOptions& options = {});

/// What was repaired and what was left, a line each; findings left because their rule has no repair share
/// one. Files are named as in validation_text().
std::string repairs_text(const RepairReport& repairs, const TypedFolders& typed);

/// A label as the user would type it: below a folder that the user has typed by that folder's name, else the
/// label itself.
std::string shown_path(const std::string& label, const TypedFolders& typed);

/// One row per finding, suppressed ones too, with a header; RFC 4180: CRLF, quotes where needed.
std::string validation_csv(const ValidationReport& report);

/// {"schema": "etak-validation/1", ...} as resources/schema/validation.schema.json describes.
std::string validation_json(const ValidationReport& report, const OutputOptions& options);

/// The JSON for the calling program itself, in two parts because a report may be large: all but "files", and the
/// array of files. Names of files are as the user typed them; a text that is no UTF-8 is an array of its bytes,
/// infinity and NaN are words ("inf", "-inf", "nan"), and each finding has its place_of() and sentence_of().
std::string validation_head_json(const ValidationReport& report, const OutputOptions& options);
std::string validation_files_json(const ValidationReport& report);

/// The form of this name: text, json, sarif, junit, github or csv; none for another name.
std::optional<std::string> validation_form(std::string_view form, const ValidationReport& report,
                                           const OutputOptions& options);

/// SARIF 2.1.0 (OASIS, 2020) with the whole rule table; at most `most_sarif_results` results, the dropped
/// ones counted in a notification of the run: GitHub shows no more.
inline constexpr std::size_t most_sarif_results = 5000;
std::string validation_sarif(const ValidationReport& report, const OutputOptions& options);

/// JUnit XML: a test suite per file, a test case per family of rules.
std::string validation_junit(const ValidationReport& report, const OutputOptions& options);

/// Workflow commands of GitHub Actions: at most 10 of each level, because GitHub shows no more; the rest is
/// summed up in a plain line. The verdict is last.
std::string validation_github(const ValidationReport& report);

/// A key that is equal for the same defect before and after a new export: rule, relative file, tile,
/// material, pointer, and outside of tiles the middle of the box in steps of 1/8 of the picture's sides (16
/// hexadecimal digits of a 64-bit FNV-1a hash).
std::string region_fingerprint(const Finding& finding, int width, int height);

}  // namespace etak
