// SPDX-License-Identifier: Apache-2.0
// Folders with one defect each, judged as `etak validate FOLDER` judges them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "core/findings/output/formats.h"
#include "tests/core/validate/checked.h"
#include "tests/core/validate/planted_sets.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ValidationReport report_on_files(const std::map<std::string, std::string>& files) {
  const TempFolder folder;
  for (const auto& [name, bytes] : files) spit(folder.file(name), bytes);
  ValidationRequest request;
  request.inputs.paths = {folder.path()};
  request.config.root = folder.path();
  request.run.door = picture_door();
  return validate(std::move(request));
}

Severity worst_of(const ValidationReport& report, std::string_view rule) {
  Severity worst = Severity::off;
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings)
      if (rule.empty() || finding.rule == rule) worst = std::max(worst, finding.severity);
  return worst;
}

}  // namespace

TEST_CASE("of the planted sets at least 95 in a hundred are found, all with their severity", "[.]") {
  struct Score {
    int planted = 0, found = 0, severities = 0, statuses = 0;
  };
  std::map<std::string, Score> scores;
  Score all;
  std::string missed;
  for (const PlantedSet& set : planted_sets(24, 37)) {
    const ValidationReport report = report_on_files(set.files);
    const Severity found = worst_of(report, set.rule);
    for (Score* score : {&scores[set.kind], &all}) {
      ++score->planted;
      score->found += found != Severity::off;
      score->severities += found == set.severity;
      score->statuses += (report.incomplete ? 2 : report.passed ? 0 : 1) == set.status;
    }
    if (found != set.severity) missed += set.kind + ":\n" + validation_text(report);
  }
  for (const auto& [kind, score] : scores)
    WARN(kind << ": " << score.found << " of " << score.planted << " found, " << score.severities
              << " of that severity, " << score.statuses << " of that exit status");
  INFO(missed);
  CHECK(100 * all.found >= 95 * all.planted);
  CHECK(all.severities == all.found);
}

TEST_CASE("right sets give no warning and no error", "[.]") {
  int alarms = 0;
  for (const PlantedSet& set : right_sets(96, 11)) {
    const ValidationReport report = report_on_files(set.files);
    if (worst_of(report, {}) < Severity::warning) continue;
    ++alarms;
    WARN(validation_text(report));
  }
  CHECK(alarms == 0);
}
