// SPDX-License-Identifier: Apache-2.0
#include "core/report/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/report/stability_rows.h"

namespace etak {
namespace {

constexpr int shown_digits = 10;

StabilityValue judged(double value, double expected, double most) {
  StabilityValue out;
  out.value = value;
  out.error = std::abs(value - expected) / (expected == 0 ? 1 : std::abs(expected));
  if (std::isnan(value)) out.error = std::numeric_limits<double>::infinity();
  out.passed = out.error <= most;
  return out;
}

std::string shown(double value) {
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
  const JsonMember members[] = {
      {"value", std::isfinite(value->value) ? json(value->value) : json(shown(value->value))},
      {"error", json(value->error)},
      {"passed", json(value->passed)}};
  return json_object(members, -1);
}

}  // namespace

std::vector<StabilityCase> stability_cases(const GlEvaluate& gl) {
  std::vector<StabilityCase> out;
  for (const StabilityFormula& row : stability_formulas()) {
    StabilityCase one;
    one.id = row.id;
    one.title = row.title;
    one.input = row.input;
    one.expected = number(row.expected, shown_digits);
    one.source = row.source;
    one.most_f64 = row.most_f64;
    one.most_f32 = row.most_f32;
    one.naive_f64 = judged(row.naive_f64(), row.expected, row.most_f64);
    one.naive_f32 = judged(row.naive_f32(), row.expected, row.most_f32);
    one.f64 = judged(row.ours_f64(), row.expected, row.most_f64);
    one.f32 = judged(row.ours_f32(), row.expected, row.most_f32);
    if (gl)
      if (const auto value = gl(row.expression))
        one.gl = judged(*value, row.expected, row.most_f32 * gl_allowance);
    one.passed = one.f64->passed && one.f32->passed && (!gl || (one.gl && one.gl->passed));
    out.push_back(std::move(one));
  }
  for (const StabilityCheck& check : stability_checks()) {
    StabilityCase one;
    one.id = check.id;
    one.title = check.title;
    one.input = check.input;
    one.expected = check.expected;
    one.source = check.source;
    one.passed = check.run(one.found);
    out.push_back(std::move(one));
  }
  return out;
}

bool all_passed(const std::vector<StabilityCase>& cases) {
  return std::all_of(cases.begin(), cases.end(), [](const StabilityCase& one) { return one.passed; });
}

std::string stability_text(const std::vector<StabilityCase>& cases) {
  std::string out;
  std::size_t failed = 0;
  for (const StabilityCase& one : cases) {
    failed += !one.passed;
    append(out, one.passed ? "ok    " : "FAIL  ", one.title, " (", one.input, ")\n");
    if (one.f64) {
      append(out, "      expected ", one.expected, ", ", one.source, "\n");
      append(out, "      usual    ", shown(one.naive_f64->value), " (double), ", shown(one.naive_f32->value),
             " (single)\n");
      append(out, "      etak     ", shown(one.f64->value), " (double), ", shown(one.f32->value),
             " (single)");
      if (one.gl) append(out, ", ", shown(one.gl->value), " (GL)");
      append(out, "; error ", shown_error(one.f64), ", ", shown_error(one.f32));
      if (one.gl) append(out, ", ", shown_error(one.gl));
      out += '\n';
    } else {
      append(out, "      expected ", one.expected, " (", one.source, ")\n      etak     ", one.found, "\n");
    }
  }
  append(out, failed == 0 ? "PASSED: " : "FAILED: ", std::to_string(failed), " of ",
         std::to_string(cases.size()), " cases fail\n");
  return out;
}

std::string stability_json(const std::vector<StabilityCase>& cases) {
  std::string rows;
  for (const StabilityCase& one : cases) {
    const JsonMember members[] = {{"id", json(one.id)},
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
                                  {"found", json(one.found)},
                                  {"passed", json(one.passed)}};
    append(rows, rows.empty() ? "\n    " : ",\n    ", json_object(members, 4));
  }
  const JsonMember members[] = {{"schema", json("etak-stability/1")},
                                {"passed", json(all_passed(cases))},
                                {"cases", "[" + rows + "\n  ]"}};
  return json_object(members, 0) + "\n";
}

std::string stability_html(const std::vector<StabilityCase>& cases) {
  std::string out =
      "<div class=\"scroll\"><table class=\"data\"><thead><tr><th>Case</th><th>Expected</th><th>As usually "
      "written, "
      "single</th><th>etak, single</th><th>etak, double</th><th>etak, GL</th><th></th></tr></thead><tbody>";
  const auto cell = [](const std::optional<StabilityValue>& value) {
    return value ? shown(value->value) + " <small>(" + shown_error(value) + ")</small>" : std::string("-");
  };
  for (const StabilityCase& one : cases) {
    append(out, "<tr><th class=\"dataset\">", escape_html(one.title), "<br><small>", escape_html(one.input),
           "</small></th>");
    if (one.f64)
      append(out, "<td class=\"num\">", one.expected, "</td><td class=\"num\">", cell(one.naive_f32),
             "</td><td class=\"num\">", cell(one.f32), "</td><td class=\"num\">", cell(one.f64),
             "</td><td class=\"num\">", cell(one.gl), "</td>");
    else
      append(out, "<td class=\"wide\">", escape_html(one.expected), "</td><td class=\"wide\" colspan=\"4\">",
             escape_html(one.found), "</td>");
    append(out, one.passed ? "<td>ok</td></tr>" : "<td class=\"refused\">fails</td></tr>");
  }
  return out += "</tbody></table></div>";
}

}  // namespace etak
