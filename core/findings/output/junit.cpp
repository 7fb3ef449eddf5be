// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"

namespace etak {
namespace {

struct Family {
  char digit;
  std::string_view title;
};
constexpr std::array families{
    Family{'0', "0xx input"},         Family{'1', "1xx specular"}, Family{'2', "2xx diffuse"},
    Family{'3', "3xx gloss"},         Family{'4', "4xx encoding"}, Family{'5', "5xx alpha and atlas"},
    Family{'6', "6xx material data"}, Family{'7', "7xx maps"},     Family{'8', "8xx material documents"},
    Family{'9', "9xx tool"}};

// Whether a file could not be checked, which is an error in JUnit; findings of a high severity are failures.
bool is_unreadable(const Finding& finding) {
  return finding.rule == "ETK001" || finding.rule == "ETK011" || finding.rule == "ETK901";
}

std::string line_of(const Finding& finding) {
  std::string out = place_of(finding) + ' ' + std::string(name(finding.severity)) + ' ' + finding.rule + ' ' +
                    finding.slug + ": " + sentence_of(finding) + '.';
  if (!finding.fix.empty()) out += " Fix: " + finding.fix;
  if (finding.suppressed) out += " (allowed: " + finding.suppression + ')';
  if (finding.baseline) out += " (known from the baseline)";
  return out;
}

struct Case {
  std::string text;
  std::size_t failures = 0, errors = 0;
};

Case test_case(const CheckedFile& file, const Family& family, Severity fail_on) {
  Case out;
  std::string failures, errors, others, first_failure, first_error;
  for (const Finding& finding : file.findings) {
    if (finding.rule.size() < 4 || finding.rule[3] != family.digit) continue;
    const std::string line = escape_html(line_of(finding)) + '\n';
    if (counts(finding) && is_unreadable(finding)) {
      if (errors.empty()) first_error = finding.rule + ' ' + sentence_of(finding);
      errors += line;
    } else if (counts(finding) && finding.severity >= fail_on) {
      if (failures.empty()) first_failure = finding.rule + ' ' + sentence_of(finding);
      failures += line;
    } else {
      others += line;
    }
  }
  out.failures = failures.empty() ? 0 : 1;
  out.errors = errors.empty() ? 0 : 1;
  out.text =
      "    <testcase classname=\"" + escape_html(file.path) + "\" name=\"" + std::string(family.title) + '"';
  if (failures.empty() && errors.empty() && others.empty()) {
    out.text += "/>\n";
    return out;
  }
  out.text += ">\n";
  if (!errors.empty())
    out.text += "      <error message=\"" + escape_html(first_error) + "\">" + errors + "</error>\n";
  if (!failures.empty())
    out.text += "      <failure message=\"" + escape_html(first_failure) + "\">" + failures + "</failure>\n";
  if (!others.empty()) out.text += "      <system-out>" + others + "</system-out>\n";
  out.text += "    </testcase>\n";
  return out;
}

}  // namespace

std::string validation_junit(const ValidationReport& report, const OutputOptions& options) {
  std::string suites;
  std::size_t tests = 0, failures = 0, errors = 0;
  for (const CheckedFile& file : report.files) {
    std::string cases;
    std::size_t suite_tests = 0, suite_failures = 0, suite_errors = 0;
    for (const Family& family : families) {
      Case result = test_case(file, family, options.fail_on);
      // The rules of the tool itself are not about the file: their family appears only when it has findings.
      if (family.digit == '9' && result.text.ends_with("/>\n")) continue;
      ++suite_tests;
      suite_failures += result.failures;
      suite_errors += result.errors;
      cases += result.text;
    }
    suites += "  <testsuite name=\"" + escape_html(file.path) + "\" tests=\"" + std::to_string(suite_tests) +
              "\" failures=\"" + std::to_string(suite_failures) + "\" errors=\"" +
              std::to_string(suite_errors) + "\">\n" + cases + "  </testsuite>\n";
    tests += suite_tests;
    failures += suite_failures;
    errors += suite_errors;
  }
  // The root element of JUnit's schema has no properties.
  const std::string of_shard = report.shard ? ", shard " + report.shard->shard.text() : "";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"etak validate" + of_shard +
         "\" tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
         "\" errors=\"" + std::to_string(errors) + "\">\n" + suites + "</testsuites>\n";
}

}  // namespace etak
