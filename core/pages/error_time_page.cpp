// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/pages/error_time_report.h"
#include "core/pages/page_style.h"

namespace etak {
namespace {

constexpr std::string_view report_css = R"css(
.scatters { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 500px), 1fr)); gap: 1.2rem 1.5rem;
  margin-top: 1.2rem; }
.scatters figure { max-width: 760px; }
.scatter { display: block; width: 100%; height: auto; }
.scatters figcaption { font-size: 1.05rem; font-weight: 600; color: var(--ink); margin: 0 0 0.3rem; }
.scatters figcaption a { font-size: 0.87rem; font-weight: 400; margin-left: 0.6rem; }
.tables { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 1050px), 1fr)); gap: 0 1.5rem; }
.tables > * { min-width: 0; }
.tables > :has(.many) { grid-column: 1 / -1; }
.key-names { columns: 15rem; font-size: 0.8rem; color: var(--ink-soft); margin: 0.3rem 0 0; padding-left: 1.8rem; }
.numbers { font-size: 1rem; margin: 1.6rem 0 0.4rem; }
main article > h2 { margin-top: 0.4rem; }
main { margin-top: 1.2rem; }
.advice { font-size: 1.05rem; border-left: 3px solid var(--plot-1); padding-left: 0.8rem; }
.data caption { caption-side: top; text-align: left; color: var(--ink-soft); font-size: 0.87rem; padding: 0 0.45rem 0.4rem; }
.data thead th { white-space: normal; min-width: 3.4rem; max-width: 8rem; }
.data tbody th { white-space: normal; min-width: 7rem; }
.data small { display: block; color: var(--ink-soft); }
.beaten { color: var(--ink-soft); }
.key { max-width: none; }
.key span { margin-right: 1.2em; white-space: nowrap; }
.key i { display: inline-block; width: 0.8em; height: 0.8em; border-radius: 50%; margin-right: 0.35em; border: 1px solid var(--ink-soft); }
.key .best { background: var(--plot-1); }
.key .open { background: var(--plot-2); }
.key .alone { border-style: dashed; }
article .data td.verdict b { color: var(--plot-1); }
article .data td.verdict em { color: var(--plot-2); font-style: normal; }
article .overview { width: 100%; }
article .overview td { white-space: normal; }
article .overview td a, article .overview .verdict { white-space: nowrap; }
article .many th, article .many td { padding: 0.25rem 0.25rem; font-size: 0.73rem; min-width: 0; }
article .many td.wide { min-width: 6rem; }
article .data td.truth { white-space: normal; min-width: 6rem; overflow-wrap: anywhere; }
article .many tbody th { min-width: 6rem; }
details > summary { cursor: pointer; margin: 0.8rem 0; color: var(--link); }
@media (max-width: 600px) {
  .key span { white-space: normal; display: block; }
  .scatters figure { overflow-x: auto; }
  .scatters .scatter { width: 520px; }
  .data caption { max-width: calc(100vw - 4rem); }
  .overview thead { display: none; }
  .overview tbody, .overview tr, .overview caption, article .overview tbody th, article .overview td { display: block; }
  article .overview small { display: inline; margin-left: 0.5em; }
  .overview tr { padding: 0.6rem 0; border-top: 1px solid var(--line); }
  article .overview tbody th, article .overview td { border: 0; padding: 0.1rem 0.45rem; text-align: left; }
}
)css";

// Turns the column titles of the tables into buttons that sort the rows. The page is complete without it.
constexpr std::string_view report_script = R"js(
(() => {
  for (const table of document.querySelectorAll('table.sorts')) {
    const body = table.tBodies[0], titles = [...table.tHead.rows[0].cells];
    titles.forEach((cell, column) => {
      const button = document.createElement('button');
      button.className = 'sortable';
      button.textContent = cell.textContent;
      button.title = 'Sort by this column';
      cell.replaceChildren(button);
      button.addEventListener('click', () => {
        const up = cell.getAttribute('aria-sort') !== 'ascending';
        for (const other of titles) other.removeAttribute('aria-sort');
        cell.setAttribute('aria-sort', up ? 'ascending' : 'descending');
        const text = (row) => row.cells[column].textContent;
        body.append(...[...body.rows].sort((a, b) => {
          const x = text(a), y = text(b), order = parseFloat(x) - parseFloat(y);
          return (up ? 1 : -1) * (Number.isNaN(order) ? x.localeCompare(y) : order);
        }));
      });
    });
  }
})();
)js";

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

bool any(const ErrorTimeTable& table, bool (*has)(const ErrorTimeRow&)) {
  return std::any_of(table.rows.begin(), table.rows.end(), has);
}

std::size_t count_of(const ErrorTimeTable& table, Verdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(table.rows.begin(), table.rows.end(),
                    [verdict](const ErrorTimeRow& row) { return row.verdict == verdict; }));
}

const ErrorTimeRow* row_named(const ErrorTimeTable& table, std::string_view id) {
  const auto at = std::find_if(table.rows.begin(), table.rows.end(),
                               [id](const ErrorTimeRow& row) { return row.id == id; });
  return at == table.rows.end() ? nullptr : &*at;
}

std::string anchor(const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  return escape_html(family.id + "-" + table.id);
}

std::string with_unit(std::string_view title, std::string_view unit) {
  return escape_html(title) + (unit.empty() ? "" : ", ") + escape_html(unit);
}

std::string verdict_cell(const ErrorTimeRow& row) {
  const std::string text(name(row.verdict));
  return "<td class=\"verdict\">" +
         (row.verdict == Verdict::unbeaten      ? "<b>" + text + "</b>"
          : row.verdict == Verdict::not_settled ? "<em>" + text + "</em>"
                                                : text) +
         "</td>";
}

void append_table(std::string& out, const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  const bool timed = any(table, [](const ErrorTimeRow& row) { return row.time.has_value(); });
  const bool noted = any(table, [](const ErrorTimeRow& row) { return !row.note.empty(); });
  const bool truths = any(table, [](const ErrorTimeRow& row) { return !row.truth.empty(); });
  // A table of more columns than the page has room for gets smaller text.
  append(out, "<div class=\"scroll\"><table id=\"", anchor(family, table), "-table\" class=\"data sorts",
         table.metrics.size() > 6 ? " many" : "", "\"><caption>", std::to_string(table.rows.size()),
         " ways in the order that they are numbered in the plot.");
  if (timed)
    append(out, " ", std::to_string(count_of(table, Verdict::unbeaten)), " unbeaten, ",
           std::to_string(count_of(table, Verdict::not_settled)), " not settled",
           truths ? "; only those with the same entry in \"Compared among\" are compared" : "",
           ". Times are medians, quartiles below.");
  append(out, "</caption><thead><tr><th>No.</th><th>Way</th>", truths ? "<th>Compared among</th>" : "");
  for (const ErrorMetric& metric : table.metrics)
    append(out, "<th>", with_unit(metric.title, metric.unit), "</th>");
  if (timed) append(out, "<th>", escape_html(table.time_unit), "</th><th>Ratio</th><th>Verdict</th>");
  append(out, noted ? "<th>Note</th>" : "", "</tr></thead><tbody>");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const ErrorTimeRow& row = table.rows[i];
    append(out, row.verdict == Verdict::beaten ? "<tr class=\"beaten\">" : "<tr>", "<td class=\"num\">",
           std::to_string(i + 1), "</td><th>", escape_html(row.title), "</th>");
    if (truths) append(out, "<td class=\"truth\">", escape_html(row.truth), "</td>");
    for (const double error : row.errors) append(out, "<td class=\"num\">", shown(error), "</td>");
    if (timed && row.time)
      append(out, "<td class=\"num\">", shown(row.time->median_ns), "<small>",
             shown(row.time->first_quartile_ns) + "\u2013" + shown(row.time->third_quartile_ns),
             "</small></td><td class=\"num\">", number(row.time->ratio, 3), "</td>");
    else if (timed)
      out += "<td></td><td></td>";
    if (timed) out += verdict_cell(row);
    if (noted) append(out, "<td class=\"wide\">", escape_html(row.note), "</td>");
    out += "</tr>";
  }
  out += "</tbody></table></div>";
}

// A row of the overview: what to take, its error and its cost.
void append_pick(std::string& out, const ErrorTimeFamily& family, const ErrorTimePick& pick) {
  const auto table = std::find_if(family.tables.begin(), family.tables.end(),
                                  [&](const ErrorTimeTable& each) { return each.id == pick.table; });
  if (table == family.tables.end()) return;
  const ErrorTimeRow* row = row_named(*table, pick.row);
  if (row == nullptr || !row->time) return;
  const ErrorMetric& metric = table->metrics[table->plotted];
  append(out, "<tr><th>", escape_html(pick.whom), "</th><td><b>", escape_html(row->title), "</b><small>",
         escape_html(pick.why), "</small></td>");
  append(out, "<td class=\"num\">", shown(row->errors[table->plotted]), "<small>",
         with_unit(metric.title, metric.unit), "</small></td>");
  append(out, "<td class=\"num\">", shown(row->time->median_ns), " ", escape_html(table->time_unit));
  if (const ErrorTimeRow* base = row_named(*table, table->base); base != nullptr && base != row)
    append(out, "<small>", number(row->time->ratio, 3), " times ", escape_html(base->title), "</small>");
  append(out, "</td>", verdict_cell(*row), "<td><a href=\"#", anchor(family, *table), "\">figure ",
         escape_html(family.letter), "</a></td><td>");
  if (!pick.command.empty()) append(out, "<code>", escape_html(pick.command), "</code>");
  out += "</td></tr>";
}

void append_overview(std::string& out, std::span<const ErrorTimeFamily> families) {
  std::size_t settled = 0, open = 0;
  for (const ErrorTimeFamily& family : families)
    for (const ErrorTimeTable& table : family.tables) {
      for (const Verdict verdict : {Verdict::unbeaten, Verdict::beaten, Verdict::alone})
        settled += count_of(table, verdict);
      open += count_of(table, Verdict::not_settled);
    }
  out +=
      "<article id=\"overview\"><h2>What to pick</h2><div class=\"scroll\"><table class=\"data sorts overview\"><caption>Errors and times of this run; each row leads to its figure, and to the command that "
      "takes it or chooses for one material within a budget of error.</caption><thead><tr><th>For</th><th>Take</th><th>Error</th><th>Cost</th><th>Verdict</th><th>Figure</th><th>Command</th></tr></thead><tbody>";
  for (const ErrorTimeFamily& family : families)
    for (const ErrorTimePick& pick : family.picks) append_pick(out, family, pick);
  append(
      out, "</tbody></table></div><p class=\"about\">", std::to_string(settled), " of ",
      std::to_string(settled + open), " timed ways have a settled verdict, ", std::to_string(open),
      open == 1 ? " has" : " have",
      " not: more rounds would be needed to tell them from a way that is closer. A tenth of the time counts as no difference. Settled covers what varied while this run was made, on this machine and with this "
      "build: between two builds, ratios of times have moved by 18 %.</p></article>");
}

void append_figures(std::string& out, const ErrorTimeFamily& family) {
  out += "<div class=\"scatters\">";
  for (const ErrorTimeTable& table : family.tables) {
    const std::string svg = error_time_svg(family, table);
    if (svg.empty()) continue;
    const std::string id = anchor(family, table);
    append(out, "<figure id=\"", id, "\"><figcaption>", escape_html(table.title), " <a href=\"#", id,
           "\">link</a>");
    for (const std::string_view file : {"csv", "svg"})
      append(out, "<a href=\"", id, ".", file, "\">", file, "</a>");
    append(out, "</figcaption>", svg, "<ol class=\"key-names\">");
    for (const ErrorTimeRow& row : table.rows)
      append(out, "<li>", escape_html(row.title), row.time ? "" : " (not timed)", "</li>");
    out += "</ol></figure>";
  }
  out += "</div>";
}

void append_family(std::string& out, const ErrorTimeFamily& family) {
  append(out, "<article id=\"", escape_html(family.id), "\"><h2>", escape_html(family.letter), ". ",
         escape_html(family.title), "</h2>");
  append(out, "<p class=\"advice\">", escape_html(family.advice), "</p>");
  append(out, "<p class=\"about\">Error against: ", escape_html(family.reference),
         ". Over: ", escape_html(family.grid), ".</p>");
  for (const ErrorTimeStrips& strips : family.strips) out += strips_html(strips);
  append_figures(out, family);
  out += "<div class=\"tables\">";
  for (const ErrorTimeTable& table : family.tables) {
    append(out, "<section><h3 class=\"numbers\">", escape_html(table.title), "</h3>");
    append_table(out, family, table);
    out += "</section>";
  }
  out += "</div>";
  for (const std::string& note : family.notes) append(out, "<p class=\"about\">", escape_html(note), "</p>");
  out += "</article>";
}

}  // namespace

std::string error_time_page(const ReportHeader& header, std::span<const ErrorTimeFamily> families,
                            std::string_view stability) {
  std::string out =
      "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>etak: error against run time</title><style>";
  append(out, page_css, report_css, strips_css(), error_time_plot_css(),
         "</style></head><body><header><h1>Error against run time</h1>");
  append(out,
         "<p class=\"lead\">Every shortcut etak knows, how far it is from the truth and what it saves.</p>");
  out +=
      "<p class=\"key\"><span><i class=\"best\"></i>unbeaten: no way to the same truth is closer for at most a tenth more time (joined by a line)</span><span><i></i>beaten</span><span><i class=\"open\"></i>not "
      "settled</span><span><i class=\"alone\"></i>alone: no other way to its truth</span></p><p class=\"about\">Dots are medians with the number of their row, bars reach from quartile to quartile, "
      "small dots are single materials, crosses those with doubtful data; both axes are logarithmic; further left is faster, further down is closer.</p><nav><a href=\"#overview\">What to pick</a>";
  for (const ErrorTimeFamily& family : families)
    append(out, "<a href=\"#", escape_html(family.id), "\">", escape_html(family.letter), " ",
           escape_html(family.title), "</a>");
  if (!stability.empty()) out += "<a href=\"#stability\">Stiff and extreme cases</a>";
  out += "</nav></header><main>";
  append_overview(out, families);
  for (const ErrorTimeFamily& family : families) append_family(out, family);
  if (!stability.empty())
    append(
        out,
        "<article id=\"stability\"><h2>Stiff and extreme cases</h2><p class=\"advice\">Formulas as usually written lose every digit, overflow or divide by zero in these places; relative errors in brackets.</p>",
        stability, "</article>");
  out += "<article><h2>Measured with</h2>";
  append_about(out, header);
  append(out, "</article></main><script>", report_script, "</script></body></html>\n");
  return out;
}

}  // namespace etak
