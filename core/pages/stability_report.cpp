// SPDX-License-Identifier: Apache-2.0
#include "core/pages/stability_report.h"

#include <cmath>

#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/base/text.h"

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
                      {"found", json(one.found)},
                      {"passed", json(one.passed)}},
                     4);
}

}  // namespace

std::string stability_text(const std::vector<StabilityCase>& cases) {
  std::string out;
  std::size_t failed = 0;
  for (const StabilityCase& one : cases) {
    failed += !one.passed;
    append(out, one.passed ? "ok    " : "FAIL  ", one.title, " (", one.input, ")\n");
    if (one.f64) {
      append(out, "      expected ", one.expected, ", ", one.source, "\n");
      append(out, "      usual    ", exact_text(one.naive_f64->value), " (double), ",
             exact_text(one.naive_f32->value), " (single)\n");
      append(out, "      etak     ", exact_text(one.f64->value), " (double), ", exact_text(one.f32->value),
             " (single)");
      if (one.gl) append(out, ", ", exact_text(one.gl->value), " (GL)");
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
  return json_document("etak-stability/1",
                       {{"passed", json(all_passed(cases))}, {"cases", json_lines_of(cases, 2, case_json)}});
}

std::string stability_html(const std::vector<StabilityCase>& cases) {
  std::string out =
      "<div class=\"scroll\"><table class=\"data\"><thead><tr><th>Case</th><th>Expected</th><th>As usually "
      "written, "
      "single</th><th>etak, single</th><th>etak, double</th><th>etak, GL</th><th></th></tr></thead><tbody>";
  const auto cell = [](const std::optional<StabilityValue>& value) {
    return value ? exact_text(value->value) + " <small>(" + shown_error(value) + ")</small>"
                 : std::string("-");
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
