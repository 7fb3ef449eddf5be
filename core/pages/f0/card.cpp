// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/material/quality.h"
#include "core/pages/f0/page_parts.h"
#include "core/pages/plot_axes.h"
#include "core/plot/f0_curves.h"
#include "core/plot/svg_plot.h"

namespace etak {
namespace {

// Dots show how densely a table was sampled; more dots than this would merge into a line.
constexpr std::size_t most_dots = 60;

// ---- plots

// The curves of one dataset.
struct Drawn {
  OpticsCurves curves;
  std::string title;
  bool bold;  // the preferred dataset
};

// One quantity over wavelength.
//   what   for the text of its curve
struct PlottedLine {
  const std::vector<double>&nm, &y;
  std::string_view what, css_class;
  bool on_right = false;
};

void add_curve(LinePlot& plot, const Drawn& drawn, const PlottedLine& line) {
  if (line.nm.empty()) return;
  plot.curves.push_back({line.nm, line.y, std::string(line.css_class) + (drawn.bold ? " bold" : ""),
                         std::string(line.what) + ", " + drawn.title, line.on_right, false});
}

// Draws the rows of the preferred table as dots on its curve. The curve has a point every nanometre and at
// the ends of the data; a row between two points gets the value that is interpolated there.
void add_dots(LinePlot& plot, const Drawn& drawn, const std::vector<double>& nm, const std::vector<double>& y,
              std::string css_class) {
  if (!drawn.bold || drawn.curves.sample_nm.size() > most_dots || nm.empty()) return;
  PlotCurve dots{{}, {}, std::move(css_class) + " dots", "", false, true};
  const Spectrum curve{nm, y};
  dots.x = drawn.curves.sample_nm;
  dots.y.resize(dots.x.size());
  resample(curve, Interpolation::linear, dots.x, dots.y);
  plot.curves.push_back(std::move(dots));
}

void append_index_plot(std::string& out, const std::string& material, const std::vector<Drawn>& all) {
  Extent n, k;
  for (const Drawn& drawn : all) {
    n.add(drawn.curves.n);
    k.add(drawn.curves.k);
  }
  if (n.empty()) return;
  LinePlot plot;
  plot.title = material + ": n and k over wavelength";
  plot.description = "n " + number(n.least, 4) + " to " + number(n.most, 4) +
                     (k.empty() ? ", no k given" : ", k " + number(k.least, 4) + " to " + number(k.most, 4)) +
                     ", 360-830 nm";
  plot.x = wavelength_axis();
  plot.strip = "url(#spectrum)";
  plot.left = nice_axis("n", n.least, n.most);
  if (!k.empty() && k.most > 0) {
    plot.right = nice_axis("k", k.least, k.most);
    plot.keys = {{"c1 bold", "n (left)"}, {"c2 bold", "k (right)"}};
  } else {
    plot.keys = {{"c1 bold", "n"}, {"", k.empty() ? "k not given" : "k = 0"}};
  }
  for (const Drawn& drawn : all) {
    add_curve(plot, drawn, {drawn.curves.n_nm, drawn.curves.n, "n", "c1"});
    if (plot.right) add_curve(plot, drawn, {drawn.curves.k_nm, drawn.curves.k, "k", "c2", true});
    add_dots(plot, drawn, drawn.curves.n_nm, drawn.curves.n, "c1");
  }
  out += svg(plot);
}

void append_reflectance_plot(std::string& out, const std::string& material, const std::vector<Drawn>& all) {
  Extent r, edge;
  for (const Drawn& drawn : all) {
    r.add(drawn.curves.r0);
    edge.add(drawn.curves.r82);
  }
  if (r.empty()) return;
  LinePlot plot;
  plot.title = material + ": reflectance over wavelength";
  plot.description =
      "R at normal incidence " + number(r.least, 3) + " to " + number(r.most, 3) +
      (edge.empty() ? "" : ", at cos 1/7 " + number(edge.least, 3) + " to " + number(edge.most, 3)) +
      ", 360-830 nm";
  plot.x = wavelength_axis();
  plot.strip = "url(#spectrum)";
  plot.left = nice_axis("R", 0, edge.empty() ? r.most : std::max(r.most, edge.most));
  plot.keys.push_back({"c3 bold", "R at 0° (F0)"});
  if (!edge.empty()) plot.keys.push_back({"c2 dashed bold", "R at 81.8° (F82)"});
  for (const Drawn& drawn : all) {
    if (!drawn.curves.r82.empty())
      add_curve(plot, drawn, {drawn.curves.r_nm, drawn.curves.r82, "R at 81.8°", "c2 dashed"});
    add_curve(plot, drawn, {drawn.curves.r_nm, drawn.curves.r0, "R at 0°", "c3"});
    add_dots(plot, drawn, drawn.curves.r_nm, drawn.curves.r0, "c3");
  }
  out += svg(plot);
}

void append_plots(std::string& out, const MaterialReport& report, const F0Options& options) {
  const Material& material = report.material;
  std::vector<Drawn> all;
  for (std::size_t i = 0; i < material.datasets.size(); ++i) {
    const Dataset& dataset = material.datasets[i];
    all.push_back({curves_of(dataset.optics, options), dataset.id, i == material.preferred});
  }
  // The preferred dataset comes last, so that it is drawn over the others.
  std::stable_partition(all.begin(), all.end(), [](const Drawn& drawn) { return !drawn.bold; });
  out += "<div class=\"plots\">";
  append_index_plot(out, material.name, all);
  append_reflectance_plot(out, material.name, all);
  out += "</div>\n";
}

// ---- swatches, numbers, sources

void append_swatches(std::string& out, const MaterialReport& report, const F0PageContext& context) {
  if (spread(report).count == 0) return;
  out += "<div class=\"swatches\">";
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const F0Result& result = report.results[i];
    if (result.refused()) continue;
    const Dataset& dataset = report.material.datasets[i];
    const auto edge = context.edge_codes(result);
    const std::string color = hex(result.srgb8);
    if (i == report.material.preferred)
      append(out, "<span class=\"ball\" style=\"background:",
             ball_paint(report.material, dataset, result, context.options()), "\"></span>");
    append(out, "<figure", i == report.material.preferred ? " class=\"big\"" : "",
           "><div class=\"chip\" data-copy=\"", color, "\" role=\"img\" ");
    append(out, "aria-label=\"F0 ", color, edge ? ", F82 " + hex(*edge) : "", "\" style=\"background:");
    append(out, color, "\">");
    if (edge) append(out, "<i style=\"background:", hex(*edge), "\"></i>");
    append(out, "</div><figcaption>", escape_html(dataset.id), "<br><code>", color,
           "</code></figcaption></figure>");
  }
  out += "</div>\n";
}

// The band: its words, and colours at the rim of its half.
void append_band_figure(std::string& out, const MaterialReport& report) {
  const auto band = band_of(report).band;
  if (!band) return;
  append(out, "<figure><div class=\"rim\">");
  for (const LinearRgb& each : half_band_colors(*band, preferred_result(report).srgb_linear))
    append(out, "<div class=\"chip\" style=\"background:", hex(srgb_u8(each)), "\"></div>");
  append(out, "</div><figcaption>Half of the publications lie in here: ", escape_html(words(*band)),
         "</figcaption></figure>\n");
}

std::string three(const LinearRgb& c) {
  return fixed(c.r, 4) + " " + fixed(c.g, 4) + " " + fixed(c.b, 4);
}

// Tenths of a nanometre below 1000 nm, whole nanometres above: enough to choose a dataset by.
std::string range_text(double first_nm, double last_nm) {
  const auto text = [](double nm) { return nm < 1000 ? number(std::round(10 * nm) / 10, 6) : fixed(nm, 0); };
  return text(first_nm) + "–" + text(last_nm);
}

void append_cell(std::string& out, std::string_view text, std::string_view css_class = "num") {
  append(out, "<td class=\"", css_class, "\">", text, "</td>");
}

void append_dataset_row(std::string& out, const Dataset& dataset, const F0Result& r, bool preferred) {
  const Coverage& c = r.coverage;
  append(out, preferred ? "<tr class=\"preferred\">" : "<tr>", "<th scope=\"row\" class=\"dataset\">",
         escape_html(dataset.id), "</th>");
  if (r.refused()) {
    out += "<td colspan=\"6\" class=\"refused\">no F0</td>";
  } else {
    append_cell(out, three(r.linear));
    append_cell(out, codes_text(r.srgb8));
    append_cell(out, fixed(r.luminance, 4));
    append_cell(out, r.zone ? name(*r.zone) : "–", r.zone == Zone::inside ? "inside" : "");
    append_cell(out, r.f82 ? three(*r.f82) : "–");
    append_cell(out, r.f82_tint ? three(*r.f82_tint) : "–");
  }
  const bool known = c.last_nm > 0;
  append_cell(out, known ? fixed(c.least(), 4) : "–");
  append_cell(out, known ? range_text(c.first_nm, c.last_nm) : "–");
  const std::string samples = std::to_string(c.samples_400_700) + " (" + number(c.largest_gap_nm, 3) + " nm)";
  append_cell(out, !known ? "–" : c.is_formula ? "formula" : samples);
  out += "</tr>\n";
}

void append_dataset_table(std::string& out, const MaterialReport& report, const F0Options& options) {
  out += "<div class=\"scroll\"><table class=\"data\"><thead><tr><th scope=\"col\">Dataset</th>";
  append(out, "<th scope=\"col\">F0, linear ", escape_html(space_name(options)), "</th>");
  for (const std::string_view title : {"8 bit", "Y", "Zone", "F82", "F82 tint", "Coverage", "Range, nm"})
    append(out, "<th scope=\"col\">", title, "</th>");
  out +=
      "<th scope=\"col\" title=\"table rows inside 400–700 nm, and the largest gap there\">Samples (gap)</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < report.results.size(); ++i)
    append_dataset_row(out, report.material.datasets[i], report.results[i], i == report.material.preferred);
  out += "</tbody></table></div>\n";
}

void append_spread(std::string& out, const MaterialReport& report) {
  const Spread s = spread(report);
  if (s.count < 2) return;
  const auto add = [&](const char* channel, double least, double most, int least8, int most8) {
    append(out, "<tr><th scope=\"row\">", channel, "</th>");
    append_cell(out, fixed(least, 4) + "–" + fixed(most, 4) + " (" + fixed(most - least, 4) + ")");
    append_cell(out, std::to_string(least8) + "–" + std::to_string(most8) + " (" +
                         std::to_string(most8 - least8) + ")");
    out += "</tr>";
  };
  append(out, "<p class=\"spread\">Spread over ", std::to_string(s.count),
         " datasets; largest colour difference from the preferred ");
  append(out, "one: ΔE<sub>2000</sub> ", fixed(largest_difference(report), 1), ".</p>\n");
  out += "<div class=\"scroll\"><table class=\"data\"><thead><tr><th scope=\"col\">Channel</th>";
  out += "<th scope=\"col\">Linear (width)</th><th scope=\"col\">8 bit (width)</th></tr></thead><tbody>";
  add("r", s.least.r, s.most.r, s.least8.r, s.most8.r);
  add("g", s.least.g, s.most.g, s.least8.g, s.most8.g);
  add("b", s.least.b, s.most.b, s.least8.b, s.most8.b);
  out += "</tbody></table></div>\n";
}

void append_link(std::string& out, std::string_view address, std::string_view text) {
  append(out, "<a href=\"", escape_html(address), "\">", escape_html(text), "</a>");
}

void append_citation(std::string& out, const Citation& citation) {
  Citation without_links = citation;
  without_links.doi.clear();
  out += escape_html(one_line(without_links));
  if (!citation.doi.empty()) {
    out += ", ";
    append_link(out, "https://doi.org/" + citation.doi, "doi:" + citation.doi);
  } else if (citation.url.starts_with("https://") || citation.url.starts_with("http://")) {
    out += ", ";
    append_link(out, citation.url, citation.url);
  }
  if (!citation.via.empty()) append(out, "; via ", escape_html(citation.via));
  if (!citation.licence.empty()) append(out, "; ", escape_html(citation.licence));
}

void append_sources(std::string& out, const MaterialReport& report) {
  out += "<ul class=\"sources\">";
  for (std::size_t i = 0; i < report.material.datasets.size(); ++i) {
    const Dataset& dataset = report.material.datasets[i];
    append(out, "<li><b>", escape_html(dataset.id), "</b> (",
           quality_text(dataset.origin, report.results[i].flags));
    if (!dataset.sample.empty()) append(out, "; ", escape_html(dataset.sample));
    if (dataset.temperature_kelvin) append(out, "; ", number(*dataset.temperature_kelvin, 5), " K");
    if (!dataset.axis.empty()) append(out, "; ", escape_html(dataset.axis), " axis");
    out += ") ";
    append_citation(out, dataset.citation);
    if (!dataset.note.empty()) append(out, "; ", escape_html(dataset.note));
    if (const std::string why = doubt(report.material, dataset); !why.empty())
      append(out, ". <span class=\"refused\">Doubtful: ", escape_html(why), "</span>");
    if (report.results[i].refused())
      append(out, ". <span class=\"refused\">No F0: ", escape_html(report.results[i].refusal), "</span>");
    out += "</li>\n";
  }
  out += "</ul>\n";
}

// The meaning of each flag in words, with the datasets that have it.
void append_flags_in_words(std::string& out, const MaterialReport& report) {
  Flags seen;
  for (const F0Result& result : report.results) seen |= result.flags;
  if (seen.none()) return;
  out += "<ul class=\"sources said\">";
  seen.for_each([&](Flag flag) {
    std::string about;
    bool all = true;
    for (std::size_t i = 0; i < report.results.size(); ++i) {
      if (!report.results[i].flags.has(flag))
        all = false;
      else
        append(about, about.empty() ? "" : ", ", escape_html(report.material.datasets[i].id));
    }
    if (all && report.results.size() > 1) about = "all datasets";
    append(out, "<li><span class=\"flag\">", name(flag), "</span> ", escape_html(meaning(flag)), " (", about,
           ")</li>\n");
  });
  out += "</ul>\n";
}

}  // namespace

void append_card(std::string& out, const MaterialReport& report, const F0PageContext& context) {
  const Material& material = report.material;
  const F0Result& result = preferred_result(report);
  append(out, "<article id=\"", anchor("m-", material.id), "\">\n<h4>", escape_html(material.name));
  append(out, " <code>", escape_html(material.id), "</code> <a class=\"up\" href=\"#",
         anchor("t-", material.id));
  out.append("\" title=\"To the table\">↑ table</a></h4>\n<p class=\"about\">");
  for (std::size_t i = 0; i < material.aliases.size(); ++i)
    append(out, i == 0 ? "Also " : ", ", escape_html(material.aliases[i]));
  if (!material.aliases.empty()) out += ". ";
  append(out, "Preferred: <b>", escape_html(material.preferred_dataset().id), "</b>");
  if (!material.preferred_reason.empty()) append(out, ", ", escape_html(material.preferred_reason));
  out += ".</p>\n";
  if (result.refused()) append(out, "<p class=\"refused\">No F0: ", escape_html(result.refusal), ".</p>\n");
  append_swatches(out, report, context);
  append_band_figure(out, report);
  append_plots(out, report, context.options());
  append_dataset_table(out, report, context.options());
  append_spread(out, report);
  append_sources(out, report);
  append_flags_in_words(out, report);
  out += "</article>\n";
}

}  // namespace etak
