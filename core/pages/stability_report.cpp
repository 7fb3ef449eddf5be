// SPDX-License-Identifier: Apache-2.0
#include "core/pages/stability_report.h"

#include <algorithm>
#include <cmath>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

constexpr int shown_digits = 10;

std::string exact_text(double value) {
  return std::isnan(value)   ? "NaN"
         : std::isinf(value) ? (value > 0 ? "Inf" : "-Inf")
                             : number(value, shown_digits);
}

std::string shown_error(const std::optional<StabilityValue>& value) {
  if (!value) return "-";
  return std::isinf(value->error) ? "all" : number(value->error, 2);
}

std::string value_json(const std::optional<StabilityValue>& value) {
  if (!value) return "null";
  return json_object(
      {{"value", std::isfinite(value->value) ? json(value->value) : json(exact_text(value->value))},
       {"error", json(value->error)},
       {"passed", json(value->passed)}},
      -1);
}

std::string case_json(const StabilityCase& one) {
  return json_object({{"id", json(one.id)},
                      {"title", json(one.title)},
                      {"input", json(one.input)},
                      {"expected", json(one.expected)},
                      {"source", json(one.source)},
                      {"naive_double", value_json(one.naive_f64)},
                      {"naive_single", value_json(one.naive_f32)},
                      {"double", value_json(one.f64)},
                      {"single", value_json(one.f32)},
                      {"gl", value_json(one.gl)},
                      {"most_double", json(one.most_f64)},
                      {"most_single", json(one.most_f32)},
                      {"usual_fails", json(usual_fails(one))},
                      {"found", json(one.found)},
                      {"passed", json(one.passed)}},
                     4);
}

// The cases in the order of a reader's interest.
struct SortedCases {
  std::vector<const StabilityCase*> first;   // cases that fail, then cases in which the usual formula fails
  std::vector<const StabilityCase*> others;  // the usual formula passes too, or there is none
  std::size_t failed = 0, with_formula = 0;  // with_formula: of the others

  explicit SortedCases(const std::vector<StabilityCase>& cases) {
    for (const StabilityCase& one : cases)
      if (!one.passed) first.push_back(&one);
    failed = first.size();
    for (const StabilityCase& one : cases) {
      if (!one.passed) continue;
      (usual_fails(one) ? first : others).push_back(&one);
      with_formula += !usual_fails(one) && one.naive_f64;
    }
  }

  std::string others_text() const {
    return std::to_string(others.size()) + " more cases come out as expected: in " +
           std::to_string(with_formula) +
           " the usual formula does too, the others are about data and have none";
  }
};

void append_case_text(std::string& out, const StabilityCase& one) {
  append(out, one.passed ? "ok    " : "FAIL  ", one.title, " (", one.input, ")\n");
  if (!one.f64) {
    append(out, "      expected ", one.expected, " (", one.source, ")\n      etak     ", one.found, "\n");
    return;
  }
  append(out, "      expected ", one.expected, ", ", one.source, "\n");
  append(out, "      usual    ", exact_text(one.naive_f64->value), " (double), ",
         exact_text(one.naive_f32->value), " (single)\n");
  append(out, "      etak     ", exact_text(one.f64->value), " (double), ", exact_text(one.f32->value),
         " (single)");
  if (one.gl) append(out, ", ", exact_text(one.gl->value), " (GL)");
  append(out, "; error ", shown_error(one.f64), ", ", shown_error(one.f32));
  if (one.gl) append(out, ", ", shown_error(one.gl));
  out += '\n';
}

void append_case_table(std::string& out, const std::vector<const StabilityCase*>& cases, bool gl) {
  append(
      out, "<div class=\"scroll\"><table class=\"data\"><caption>", std::to_string(cases.size()),
      " cases; relative errors in brackets.</caption><thead><tr><th>Case</th><th>Expected</th><th>As usually written, single</th><th>etak, single</th><th>etak, double</th>",
      gl ? "<th>etak, GL</th>" : "", "<th>Outcome</th></tr></thead><tbody>");
  const auto cell = [](const std::optional<StabilityValue>& value) {
    return "<td class=\"num\">" +
           (value ? exact_text(value->value) + " <small>(" + shown_error(value) + ")</small>"
                  : std::string("-")) +
           "</td>";
  };
  for (const StabilityCase* one : cases) {
    append(out, "<tr><th class=\"dataset\">", escape_html(one->title), "<br><small>", escape_html(one->input),
           "</small></th>");
    if (one->f64)
      append(out, "<td class=\"num\">", one->expected, "</td>", cell(one->naive_f32), cell(one->f32),
             cell(one->f64), gl ? cell(one->gl) : "");
    else
      append(out, "<td class=\"wide\">", escape_html(one->expected), "</td><td class=\"wide\" colspan=\"",
             gl ? "4" : "3", "\">", escape_html(one->found), "</td>");
    out += one->passed ? "<td>ok</td></tr>" : "<td class=\"refused\">fails</td></tr>";
  }
  out += "</tbody></table></div>";
}

}  // namespace

std::string stability_text(const std::vector<StabilityCase>& cases, bool all) {
  const SortedCases sorted(cases);
  std::string out;
  for (const StabilityCase* one : sorted.first) append_case_text(out, *one);
  if (all)
    for (const StabilityCase* one : sorted.others) append_case_text(out, *one);
  else if (!sorted.others.empty())
    append(out, "...   ", sorted.others_text(), "\n");
  append(out, sorted.failed == 0 ? "PASSED: " : "FAILED: ", std::to_string(sorted.failed), " of ",
         std::to_string(cases.size()), " cases fail\n");
  return out;
}

std::string stability_json(const std::vector<StabilityCase>& cases) {
  return json_document("etak-stability/1",
                       {{"passed", json(all_passed(cases))}, {"cases", json_lines_of(cases, 2, case_json)}});
}

std::string stability_html(const std::vector<StabilityCase>& cases) {
  const SortedCases sorted(cases);
  const bool gl =
      std::any_of(cases.begin(), cases.end(), [](const StabilityCase& one) { return one.gl.has_value(); });
  std::string out;
  append_case_table(out, sorted.first, gl);
  append(out, "<details><summary>", sorted.others_text(), "</summary>");
  append_case_table(out, sorted.others, gl);
  return out += "</details>";
}

}  // namespace etak
