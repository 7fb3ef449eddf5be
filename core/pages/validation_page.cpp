// SPDX-License-Identifier: Apache-2.0
#include "core/pages/validation_page.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>

#include "core/base/bytes/base64.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/judge/rules.h"
#include "core/pages/page_style.h"
#include "core/pages/validation_pictures.h"

namespace etak {
namespace {

constexpr std::string_view validation_css = R"css(
.verdict { display: inline-block; padding: 0.3rem 0.9rem; border-radius: 8px; font-size: 1.15rem; font-weight: 600; }
.verdict.passed { background: #d9efdc; color: #12481c; }
.verdict.failed { background: #f7d4d4; color: #7a1010; }
.severity { display: inline-block; min-width: 4.6rem; text-align: center; padding: 0 0.45rem; border-radius: 4px;
  font-size: 0.8rem; font-weight: 700; }
.severity.error { background: #b3261e; color: #fff; }
.severity.warning { background: #ffc46b; color: #3b2500; }
.severity.info { background: #cfe0f5; color: #12314f; }
.shots { display: flex; flex-wrap: wrap; gap: 1.25rem; margin: 0.75rem 0; align-items: flex-start; }
.shot { margin: 0; max-width: 100%; }
.shot figcaption { font-size: 0.83rem; color: var(--ink-soft); overflow-wrap: anywhere; max-width: 256px; }
.stack { position: relative; display: inline-block; line-height: 0; background: #777; }
.stack img, .stack svg { display: block; width: 100%; height: 100%; image-rendering: auto; }
.stack .over { position: absolute; inset: 0; }
.heat:not(:checked) ~ .stack .heat-map { display: none; }
.toggle { font-size: 0.83rem; }
.stack rect { fill: none; stroke: #fff; stroke-width: 2; vector-effect: non-scaling-stroke; paint-order: stroke; }
.stack rect.dark { stroke: #000; stroke-width: 4; }
.hist { width: 460px; max-width: 100%; height: auto; background: var(--card); }
.hist .zone { fill: var(--warn-bg); }
.hist .bar { stroke: var(--ink); stroke-width: 1.75; }
.hist .bar.in { stroke: var(--bad); }
.hist line { stroke: var(--ink-soft); }
.hist text { font-size: 12px; fill: var(--ink-soft); }
.finding { border-top: 1px solid var(--line); padding: 0.6rem 0; }
.finding p { margin: 0.2rem 0; max-width: 100ch; overflow-wrap: anywhere; }
.finding .place { color: var(--ink-soft); font-size: 0.87rem; }
.finding i { display: inline-block; width: 1.6rem; height: 1rem; border: 1px solid var(--line); vertical-align: -2px; }
.taken { opacity: 0.75; }
.names { columns: 22rem; font-size: 0.87rem; padding-left: 1.1rem; overflow-wrap: anywhere; }
article h3 { margin: 0; overflow-wrap: anywhere; }
summary h3 { display: inline; }
summary { cursor: pointer; }
.filters { display: none; flex-wrap: wrap; gap: 0.5rem 1.25rem; margin: 0.5rem 0 1rem; position: sticky; top: 0; z-index: 2;
  background: var(--page); padding: 0.5rem 0; }
@supports selector(:has(a)) { .filters { display: flex; } }
.filters select { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 6px;
  padding: 0.2rem 0.4rem; max-width: min(70vw, 24rem); }
)css";

// ---- histogram

// A bar for each code of F0. Heights are square roots of the counts, because a material of a single F0 would
// otherwise leave all other bars too low to be seen.
void append_histogram(std::string& out, const std::array<std::size_t, 256>& counts,
                      const Settings& settings) {
  constexpr double left = 10, width = 440, top = 16, height = 110, step = width / 256;
  const auto x_of = [&](double code) { return left + (code + 0.5) * step; };
  const double low = x_of(encoded(settings.zone.low, settings.transfer));
  const double high = x_of(encoded(settings.zone.high, settings.transfer));
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  std::size_t all = 0, inside = 0;
  for (std::size_t code = 0; code < 256; ++code) {
    all += counts[code];
    const double y = decoded(static_cast<double>(code), settings.transfer);
    if (y > settings.zone.low && y < settings.zone.high) inside += counts[code];
  }
  const std::string share = fixed(all == 0 ? 0 : 100 * double(inside) / double(all), 2);
  append(out,
         "<figure class=\"shot\"><svg class=\"hist\" viewBox=\"0 0 460 170\" role=\"img\" "
         "aria-label=\"Histogram of F0: ",
         share, " % of the texels lie in the forbidden zone\">");
  append(out, "<rect class=\"zone\" x=\"", fixed(low, 1), "\" y=\"", fixed(top, 1), "\" width=\"",
         fixed(high - low, 1), "\" height=\"", fixed(height, 1), "\"/>");
  // One path for the bars outside of the zone and one for those inside keeps the page small.
  for (const bool in : {false, true}) {
    std::string bars;
    for (std::size_t code = 0; code < 256; ++code) {
      const double y = decoded(static_cast<double>(code), settings.transfer);
      if (counts[code] == 0 || (y > settings.zone.low && y < settings.zone.high) != in) continue;
      const double tall = std::max(1.0, height * std::sqrt(double(counts[code]) / double(most)));
      append(bars, "M", fixed(left + (double(code) + 0.5) * step, 1), ' ', fixed(top + height, 1), "v-",
             fixed(tall, 0));
    }
    if (!bars.empty()) append(out, "<path class=\"bar", in ? " in" : "", "\" d=\"", bars, "\"/>");
  }
  append(out, "<line x1=\"10\" y1=\"126\" x2=\"450\" y2=\"126\"/>");
  for (const double tick : {0.0, 0.04, 0.2, 0.45, 0.7, 1.0}) {
    const double x = x_of(encoded(tick, settings.transfer));
    append(out, "<line x1=\"", fixed(x, 1), "\" y1=\"126\" x2=\"", fixed(x, 1), "\" y2=\"131\"/><text x=\"",
           fixed(x, 1), "\" y=\"145\" text-anchor=\"",
           tick == 1   ? "end"
           : tick == 0 ? "start"
                       : "middle",
           "\">", number(tick, 3), "</text>");
  }
  append(out,
         "<text x=\"230\" y=\"163\" text-anchor=\"middle\">luminance of F0 (square-root heights)</text>");
  append(out, "</svg><figcaption>F0 against the forbidden zone: ", share, " % of ", grouped(all),
         " texels inside</figcaption></figure>\n");
}

// ---- pictures

void append_picture(std::string& out, const ValidationPicture& picture, const std::string& id) {
  append(out, "<figure class=\"shot\">");
  if (!picture.heat_png.empty())
    append(out, "<input type=\"checkbox\" class=\"heat\" id=\"", id, "\"> <label class=\"toggle\" for=\"", id,
           "\">heat map</label><br>");
  // The longer side always takes 256 pixels: small pictures are enlarged so that their boxes can be seen.
  const int longest = std::max({picture.width, picture.height, 1});
  const double scale = 256.0 / longest;
  append(out, "<div class=\"stack\" style=\"width: ", fixed(std::max(8.0, picture.width * scale), 0),
         "px; height: ", fixed(std::max(8.0, picture.height * scale), 0), "px\">");
  append(out, "<img alt=\"", escape_html(picture.label), "\" src=\"data:image/png;base64,",
         base64(picture.png), "\">");
  if (!picture.heat_png.empty())
    append(out, "<img class=\"over heat-map\" alt=\"where the findings lie\" src=\"data:image/png;base64,",
           base64(picture.heat_png), "\">");
  append(out, "<svg class=\"over\" viewBox=\"0 0 ", std::to_string(picture.width), ' ',
         std::to_string(picture.height), "\" preserveAspectRatio=\"none\" aria-hidden=\"true\">");
  for (std::size_t i = 0; i < picture.boxes.size(); ++i) {
    const PixelBox& box = picture.boxes[i];
    const auto before = picture.boxes.begin() + static_cast<std::ptrdiff_t>(i);
    const bool whole = box.width >= picture.width && box.height >= picture.height;
    if (whole || std::find(picture.boxes.begin(), before, box) != before) continue;
    for (const char* name : {"dark", "light"})
      append(out, "<rect class=\"", name, "\" x=\"", std::to_string(box.x), "\" y=\"", std::to_string(box.y),
             "\" width=\"", std::to_string(box.width), "\" height=\"", std::to_string(box.height), "\"/>");
  }
  append(out, "</svg></div><figcaption>", escape_html(picture.label), ", ", std::to_string(picture.width),
         " x ", std::to_string(picture.height), "</figcaption></figure>\n");
}

// ---- findings

void append_finding(std::string& out, const Finding& finding) {
  append(out, "<div class=\"finding ", finding.rule, ' ', name(finding.severity),
         counts(finding) ? "" : " taken", "\"><p><span class=\"severity ", name(finding.severity), "\">",
         name(finding.severity), "</span> <a href=\"#", finding.rule, "\">", finding.rule, ' ',
         escape_html(finding.slug), "</a> <span class=\"place\">", escape_html(place_of(finding)),
         "</span></p>\n<p>");
  if (finding.byte) {
    const auto& b = *finding.byte;
    append(out, "<i style=\"background: rgb(", std::to_string(b[0]), ',', std::to_string(b[1]), ',',
           std::to_string(b[2]), ")\"></i> ");
  }
  append(out, escape_html(sentence_of(finding)), ".</p>");
  if (!finding.limit.empty())
    append(out, "<p>Found ", escape_html(finding.value), "; limit ", escape_html(finding.limit), ".</p>");
  if (!finding.fix.empty()) append(out, "<p><b>Fix.</b> ", escape_html(finding.fix), "</p>");
  if (!finding.nearest.empty()) {
    out += "<p>Nearest materials: ";
    for (std::size_t i = 0; i < finding.nearest.size(); ++i)
      append(out, i == 0 ? "" : ", ", escape_html(finding.nearest[i].id), " (",
             escape_html(finding.nearest[i].dataset), ", ", number(finding.nearest[i].bytes, 2), " codes)");
    out += ".</p>";
  }
  if (finding.suppressed)
    append(out, "<p><b>Allowed.</b> ", escape_html(finding.suppression), "</p>");
  else if (finding.baseline)
    out += "<p><b>Known</b> from the baseline.</p>";
  out += "</div>\n";
}

void append_file(std::string& out, const CheckedFile& file, const ValidationPageFile& pictures,
                 std::size_t index, const ValidationPageOptions& options) {
  append(out, "<article class=\"file\" id=\"file-", std::to_string(index), "\"><details",
         worst_of(file) > Severity::info ? " open" : "", "><summary><h3>", escape_html(file.path),
         "</h3> <span class=\"policy\">", grouped(file.findings.size()),
         file.findings.size() == 1 ? " finding" : " findings", "</span></summary>");
  for (const std::string& companion : file.companions)
    append(out, "<p class=\"policy\">with ", escape_html(companion), "</p>");
  if (!pictures.pictures.empty() || pictures.f0) {
    out += "<div class=\"shots\">\n";
    for (std::size_t i = 0; i < pictures.pictures.size(); ++i)
      append_picture(out, pictures.pictures[i], "heat-" + std::to_string(index) + "-" + std::to_string(i));
    if (pictures.f0) append_histogram(out, *pictures.f0, options.settings);
    out += "</div>\n";
  }
  if (pictures.left_out)
    out +=
        "<p class=\"policy\">Its pictures are left out, so that the page stays small; "
        "check the file alone to see them.</p>";
  // The worst findings come first; findings that are allowed or known come last.
  std::vector<const Finding*> sorted;
  for (const Finding& finding : file.findings) sorted.push_back(&finding);
  std::ranges::stable_sort(sorted, std::greater{}, [](const Finding* f) { return weight(*f); });
  const auto folded =
      std::ranges::find_if(sorted, [](const Finding* f) { return weight(*f) <= Severity::info; });
  std::for_each(sorted.begin(), folded, [&](const Finding* finding) { append_finding(out, *finding); });
  // Findings that need no work are folded beside those that do. Where there are no others, the whole file is folded.
  const std::size_t rest = static_cast<std::size_t>(sorted.end() - folded);
  const bool fold = folded != sorted.begin() && rest > 0;
  if (fold)
    append(out, "<details><summary class=\"policy\">", grouped(rest), " more, for information</summary>\n");
  std::for_each(folded, sorted.end(), [&](const Finding* finding) { append_finding(out, *finding); });
  out += fold ? "</details></details></article>\n" : "</details></article>\n";
}

// ---- the page's frame

std::map<std::string, std::size_t> rules_found(const ValidationReport& report) {
  std::map<std::string, std::size_t> found;
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings) ++found[finding.rule];
  return found;
}

void append_navigation(std::string& out, const ValidationReport& report) {
  out += "<nav aria-label=\"Rules\">";
  for (const auto& [id, count] : rules_found(report))
    if (const Rule* rule = find_rule(id))
      append(out, "<a href=\"#", id, "\">", id, ' ', rule->slug, " <span>", grouped(count), "</span></a>");
  out += "</nav>";
}

// ---- filters

// Files that the list of the filter names; in a browser more would be no list to choose from.
constexpr std::size_t most_listed_files = 300;

struct FilterValue {
  std::string value, text;
};

// A list to choose from. Where one of its values is chosen, what `hides` matches for that value is not shown.
template <class Hides>
void append_filter(std::string& out, std::string& css, std::string_view id, std::string_view title,
                   const std::vector<FilterValue>& choices, Hides hides) {
  append(out, "<label>", title, " <select id=\"", id, "\"><option value=\"\">all</option>");
  for (const FilterValue& each : choices) {
    append(out, "<option value=\"", each.value, "\">", escape_html(each.text), "</option>");
    append(css, "main:has(#", id, " option[value=\"", each.value, "\"]:checked) :is(", hides(each.value),
           ") { display: none; }\n");
  }
  out += "</select></label>\n";
}

// Filters by severity, rule and file that need no script: the style sheet asks what is chosen. They are shown
// where the browser knows :has().
void append_filters(std::string& out, const ValidationReport& report,
                    const std::vector<std::size_t>& with_findings) {
  std::vector<FilterValue> severities, rules, files;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::info}) {
    const auto has = [&](const CheckedFile& file) {
      return std::ranges::any_of(file.findings, [&](const Finding& f) { return f.severity == severity; });
    };
    if (std::ranges::any_of(report.files, has))
      severities.push_back({std::string(name(severity)), std::string(name(severity))});
  }
  for (const auto& [id, count] : rules_found(report))
    if (const Rule* rule = find_rule(id)) rules.push_back({id, id + ' ' + std::string(rule->slug)});
  for (const std::size_t i : with_findings)
    if (files.size() < most_listed_files) files.push_back({std::to_string(i), report.files[i].path});
  const auto without_class = [](const std::string& value) {
    return ".finding:not(." + value + "), .file:not(:has(.finding." + value + "))";
  };
  std::string css;
  out += "<form class=\"filters\" aria-label=\"Filters\">";
  append_filter(out, css, "show-severity", "Severity", severities, without_class);
  append_filter(out, css, "show-rule", "Rule", rules, without_class);
  append_filter(out, css, "show-file", "File", files,
                [](const std::string& value) { return ".file:not(#file-" + value + ")"; });
  append(out, "</form>\n<style>\n", css, "</style>\n");
}

void append_rules(std::string& out, const ValidationReport& report) {
  const auto found = rules_found(report);
  if (found.empty()) return;
  out += "<section id=\"rules\"><h2>The rules that spoke</h2>\n";
  for (const auto& [id, count] : found) {
    const Rule* rule = find_rule(id);
    if (rule == nullptr) continue;
    append(out, "<article id=\"", id, "\"><h3>", id, ' ', rule->slug, "</h3><p class=\"policy\">",
           rule->family(), "; ", grouped(count), count == 1 ? " finding" : " findings", "; severity ",
           name(rule->severity.standard), ", strict profile ", name(rule->severity.strict), "</p>\n<p>",
           escape_html(rule->what), "</p><p><b>Why.</b> ", escape_html(rule->why), "</p>");
    append(out, "<p><b>Example.</b> ", escape_html(rule->example), "</p><p><b>Fix.</b> ",
           escape_html(rule->fix), "</p>");
    append(out, "<p class=\"policy\">", escape_html(rule->source), "</p></article>\n");
  }
  out += "</section>\n";
}

}  // namespace

std::string validation_page(const ValidationReport& report, std::span<const ValidationPageFile> files,
                            const ValidationPageOptions& options) {
  assert(files.size() == report.files.size());
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>etak validate</title>\n<style>";
  append(out, page_css, validation_css, "</style></head>\n<body>\n<header><h1>Materials checked</h1>\n");
  const bool passed = report.passed && !report.incomplete;
  append(out, "<p class=\"verdict ", passed ? "passed" : "failed", "\">", escape_html(verdict_of(report)),
         "</p>\n");
  append(out, "<p class=\"policy\">Profile ", escape_html(report.profile), ", transfer ",
         escape_html(report.transfer), ", fails on ", name(options.settings.fail_on), ". etak ",
         escape_html(options.version), ", settings ", escape_html(report.settings_hash), ".</p>\n");
  if (report.merged) out += "<p class=\"policy\">Merged from shards, therefore without pictures.</p>\n";
  append_navigation(out, report);
  out += "</header>\n<main>\n";
  const std::vector<std::size_t> with_findings = page_order(report);
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < report.files.size(); ++i)
    if (report.files[i].findings.empty()) without.push_back(i);
  if (!with_findings.empty()) {
    out += "<section id=\"findings\"><h2>Findings</h2>\n";
    append_filters(out, report, with_findings);
    for (const std::size_t i : with_findings) append_file(out, report.files[i], files[i], i, options);
    out += "</section>\n";
  }
  append_rules(out, report);
  if (!without.empty()) {
    append(out, "<section id=\"without\"><h2>Without findings</h2>\n<details><summary>",
           grouped(without.size()), without.size() == 1 ? " file or set" : " files and sets",
           "</summary><ul class=\"names\">\n");
    for (const std::size_t i : without) append(out, "<li>", escape_html(report.files[i].path), "</li>\n");
    out += "</ul></details></section>\n";
  }
  return out + "</main>\n</body></html>\n";
}

}  // namespace etak
