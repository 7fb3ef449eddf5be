// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/pages/error_time_report.h"
#include "core/pages/page_style.h"

namespace etak {
namespace {

constexpr std::string_view scatter_css = R"css(
.scatters { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 500px), 1fr)); gap: 1.2rem 1.5rem;
  margin-top: 1.2rem; }
.scatter { display: block; width: 100%; max-width: 760px; height: auto; }
.scatters figcaption { font-size: 1.05rem; font-weight: 600; color: var(--ink); margin: 0 0 0.3rem; }
.numbers { font-size: 1rem; margin: 1.6rem 0 0.4rem; }
main article > h2 { margin-top: 0.4rem; }
main { margin-top: 1.2rem; }
.scatter text { fill: var(--ink-soft); font: 12px system-ui, "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums; }
.scatter .label, .scatter .name { fill: var(--ink); }
.scatter .name { font-size: 11px; }
.scatter .name.grey { fill: var(--ink-soft); }
.scatter .grid { stroke: var(--line); fill: none; stroke-width: 0.75; }
.scatter .axis { stroke: var(--ink-soft); fill: none; }
.scatter .leader { stroke: var(--ink-soft); fill: none; stroke-width: 0.5; }
.scatter .front { stroke: var(--plot-1); fill: none; stroke-width: 1.5; }
.scatter .range { fill: none; stroke-width: 1.5; stroke: var(--ink-soft); }
.scatter .range.best { stroke: var(--plot-1); }
.scatter circle { fill: var(--plot-2); }
.scatter circle.best { fill: var(--plot-1); }
.scatter circle.grey { fill: none; stroke: var(--ink-soft); }
.advice { font-size: 1.05rem; border-left: 3px solid var(--plot-1); padding-left: 0.8rem; }
.data thead th { white-space: normal; min-width: 4rem; max-width: 9rem; }
.data tbody th { white-space: normal; }
.beaten { color: var(--ink-soft); }
.key { max-width: none; }
.key span { margin-right: 1.2em; white-space: nowrap; }
.key i { display: inline-block; width: 0.7em; height: 0.7em; border-radius: 50%; margin-right: 0.35em; }
article .data td.verdict b { color: var(--plot-1); }
article .many th, article .many td { padding: 0.25rem 0.3rem; font-size: 0.75rem; min-width: 0; }
)css";

// Three significant digits; from 1000 to ten million all digits before the point, without an exponent.
std::string shown(double value) {
  return std::abs(value) >= 1000 && std::abs(value) < 1e7 ? fixed(value, 0) : number(value, 3);
}

void append_about(std::string& out, const ReportHeader& h) {
  const auto row = [&](std::string_view key, std::string_view value) {
    if (!value.empty()) append(out, "<dt>", key, "</dt><dd>", escape_html(value), "</dd>");
  };
  out += "<dl>";
  row("Processor", h.cpu);
  row("Graphics", h.gpu);
  row("Compiler", h.compiler);
  row("Flags", h.flags);
  row("etak", h.version + (h.commit.empty() ? "" : ", " + h.commit));
  row("Effort", h.effort + ", " + std::to_string(h.repeats) + " repeats in turn, median and quartiles; " +
                    std::to_string(h.threads) + (h.threads == 1 ? " thread" : " threads"));
  row("Clock", "an empty loop takes " + shown(h.empty_loop_ns) + " ns");
  out += "</dl>";
}

void append_table(std::string& out, const ErrorTimeTable& table) {
  // A table of more columns than the page has room for gets smaller text.
  append(out, "<div class=\"scroll\"><table class=\"data", table.metrics.size() > 8 ? " many" : "",
         "\"><thead><tr><th>Way</th>");
  for (const ErrorMetric& metric : table.metrics)
    append(out, "<th>", escape_html(metric.title), metric.unit.empty() ? "" : ", ", escape_html(metric.unit),
           "</th>");
  const bool timed = std::any_of(table.rows.begin(), table.rows.end(),
                                 [](const ErrorTimeRow& row) { return row.time.has_value(); });
  if (timed) append(out, "<th>", escape_html(table.time_unit), "</th><th>Quartiles</th><th>Ratio</th>");
  const bool noted = std::any_of(table.rows.begin(), table.rows.end(),
                                 [](const ErrorTimeRow& row) { return !row.note.empty(); });
  append(out, timed ? "<th>Verdict</th>" : "", noted ? "<th>Note</th>" : "", "</tr></thead><tbody>");
  for (const ErrorTimeRow& row : table.rows) {
    append(out, row.dominated ? "<tr class=\"beaten\">" : "<tr>", "<th>", escape_html(row.title), "</th>");
    for (const double error : row.errors) append(out, "<td class=\"num\">", shown(error), "</td>");
    if (timed && row.time)
      append(out, "<td class=\"num\">", shown(row.time->median_ns), "</td><td class=\"num\">",
             shown(row.time->first_quartile_ns) + "\u2013" + shown(row.time->third_quartile_ns),
             "</td><td class=\"num\">", number(row.time->ratio, 3), "</td>");
    else if (timed)
      out += "<td></td><td></td><td></td>";
    if (timed)
      append(out, "<td class=\"verdict\">",
             row.pareto      ? "<b>unbeaten</b>"
             : row.dominated ? "beaten"
             : row.time      ? "within spread"
                             : "not timed",
             "</td>");
    if (noted) append(out, "<td class=\"wide\">", escape_html(row.note), "</td>");
    out += "</tr>";
  }
  out += "</tbody></table></div>";
}

void append_family(std::string& out, const ErrorTimeFamily& family) {
  append(out, "<article id=\"", escape_html(family.id), "\"><h2>", escape_html(family.letter), ". ",
         escape_html(family.title), "</h2>");
  append(out, "<p class=\"advice\">", escape_html(family.advice), "</p>");
  append(out, "<p class=\"about\">Error against: ", escape_html(family.reference),
         ". Over: ", escape_html(family.grid), ".</p>");
  out += "<div class=\"scatters\">";
  for (const ErrorTimeTable& table : family.tables)
    if (const std::string svg = error_time_svg(family, table); !svg.empty())
      append(out, "<figure><figcaption>", escape_html(table.title), "</figcaption>", svg, "</figure>");
  out += "</div>";
  for (const ErrorTimeTable& table : family.tables) {
    append(out, "<h3 class=\"numbers\">", escape_html(table.title), "</h3>");
    append_table(out, table);
  }
  for (const std::string& note : family.notes) append(out, "<p class=\"about\">", escape_html(note), "</p>");
  out += "</article>";
}

}  // namespace

std::string error_time_page(const ReportHeader& header, std::span<const ErrorTimeFamily> families,
                            std::string_view stability) {
  std::string out =
      "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>etak: error against run time</title><style>";
  append(out, page_css, scatter_css, "</style></head><body><header><h1>Error against run time</h1>");
  append(out,
         "<p class=\"lead\">Every shortcut etak knows, how far it is from the truth and what it saves.</p>");
  append(
      out,
      "<p class=\"key\"><span><i style=\"background:var(--plot-1)\"></i>unbeaten: nothing is both faster and "
      "closer (joined by a line)</span><span><i style=\"background:var(--plot-2)\"></i>beaten, but within "
      "the spread of the times</span><span><i style=\"border:1px solid var(--ink-soft)\"></i>beaten in both, "
      "beyond the quartiles</span></p><p class=\"about\">Points are medians, bars reach from quartile to "
      "quartile; both axes are logarithmic; further left is faster, further down is closer.</p><nav>");
  for (const ErrorTimeFamily& family : families)
    append(out, "<a href=\"#", escape_html(family.id), "\">", escape_html(family.letter), " ",
           escape_html(family.title), "</a>");
  if (!stability.empty()) out += "<a href=\"#stability\">Stiff and extreme cases</a>";
  out += "</nav></header><main>";
  for (const ErrorTimeFamily& family : families) append_family(out, family);
  if (!stability.empty())
    append(
        out,
        "<article id=\"stability\"><h2>Stiff and extreme cases</h2><p class=\"advice\">Formulas as usually "
        "written lose every digit, overflow or divide by zero in these places; relative errors in "
        "brackets.</p>",
        stability, "</article>");
  out += "<article><h2>Measured with</h2>";
  append_about(out, header);
  return out += "</article></main></body></html>\n";
}

}  // namespace etak
