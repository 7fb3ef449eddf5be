// SPDX-License-Identifier: Apache-2.0
#include "core/plot/plot_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

constexpr PlotColors light_colors{
    "#ffffff",
    "#1c1c1c",
    "#5c5c5c",
    "#d8d8d8",
    {"#1f6fb4", "#c4500c", "#1c1c1c", "#2a8036", "#8a4fc0", "#08787a", "#c03030", "#2a8036", "#3a5fd0"}};
constexpr PlotColors dark_colors{
    "#202020",
    "#ececec",
    "#a8a8a8",
    "#3f3f3f",
    {"#6fb3f2", "#f29b5a", "#ececec", "#79d08a", "#c39af0", "#5fd0d0", "#ff8080", "#80e090", "#8aa8ff"}};

constexpr double row_height = 17;

}  // namespace

const PlotColors& plot_colors(bool dark) {
  return dark ? dark_colors : light_colors;
}

PlotStyle plot_style(std::string_view css_class) {
  PlotStyle out;
  while (!css_class.empty()) {
    const std::size_t end = std::min(css_class.find(' '), css_class.size());
    const std::string_view word = css_class.substr(0, end);
    css_class.remove_prefix(std::min(end + 1, css_class.size()));
    if (word.size() == 2 && word[0] == 'c' && word[1] >= '1' && word[1] <= '9')
      out.color = static_cast<std::size_t>(word[1] - '1');
    else if (word == "bold")
      out.bold = true;
    else if (word == "dots")
      out.dots = true;
    else if (word == "dashed")
      out.dash = PlotStyle::Dash::dashed;
    else if (word == "dotted")
      out.dash = PlotStyle::Dash::dotted;
    else if (word == "dashdot")
      out.dash = PlotStyle::Dash::dashdot;
  }
  return out;
}

std::string svg_head(double width, double height, std::string_view title, std::string_view description,
                     bool dark) {
  const PlotColors& colors = plot_colors(dark);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(2 * width, 6) +
                    "\" height=\"" + number(2 * height, 6) + "\" viewBox=\"0 0 " + number(width, 6) + " " +
                    number(height, 6) + "\" role=\"img\">\n<title>";
  append(out, escape_html(title), "</title>\n");
  if (!description.empty()) append(out, "<desc>", escape_html(description), "</desc>\n");
  append(
      out, "<style>\ntext { fill: ", colors.ink_soft,
      "; font: 12px \"DejaVu Sans\", \"Noto Sans\", sans-serif; }\n.label { fill: ", colors.ink,
      "; }\n.grid { stroke: ", colors.line,
      "; fill: none; stroke-width: 0.75; }\n.axis { stroke: ", colors.ink_soft,
      "; fill: none; }\n.curve { fill: none; stroke-width: 1.4; stroke-linejoin: round; stroke-linecap: round; }\n"
      ".bold { stroke-width: 2.2; }\n.dots { stroke-width: 4; }\n.dashed { stroke-dasharray: 6 4; }\n"
      ".dotted { stroke-dasharray: 1.5 3.5; }\n.dashdot { stroke-dasharray: 8 3 1.5 3; }\n");
  for (std::size_t i = 0; i < 9; ++i)
    append(out, ".c", std::to_string(i + 1), " { stroke: ", colors.series[i], "; }\n");
  append(out, "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"", colors.background, "\"/>\n");
  return out;
}

std::string svg_legend(const std::vector<PlotKey>& keys, double left, double top, double width,
                       double& height) {
  constexpr double sample = 26, gap = 6, between = 16, per_letter = 7.2;
  std::string out;
  double x = left, y = top + 12;
  for (const PlotKey& key : keys) {
    const double wide = (key.css_class.empty() ? 0 : sample + gap) +
                        per_letter * static_cast<double>(display_width(key.text));
    if (x > left && x + wide > left + width) {
      x = left;
      y += row_height;
    }
    double text_x = x;
    if (!key.css_class.empty()) {
      append(out, "<path class=\"curve ", escape_html(key.css_class), "\" d=\"M", fixed(x, 1), " ",
             fixed(y - 4, 1), "h", fixed(sample, 0), "\"/>");
      text_x += sample + gap;
    }
    append(out, "<text x=\"", fixed(text_x, 1), "\" y=\"", fixed(y, 1), "\">", escape_html(key.text),
           "</text>\n");
    x += wide + between;
  }
  height = keys.empty() ? 0 : y - top - 12 + row_height;
  return out;
}

std::string svg_file(const LinePlot& plot, bool dark) {
  constexpr double height = 270;  // of the plot that svg() draws
  double legend = 0;
  const std::string keys = svg_legend(plot.keys, 10, 6, plot_width - 20, legend);
  LinePlot bare = plot;
  bare.keys.clear();
  bare.strip.clear();
  std::string inner = svg(bare);
  // svg_head() writes title, description and colours; of svg() only the drawing is needed.
  const std::size_t begin = inner.find("<path class=\"grid\"");
  inner = inner.substr(begin == inner.npos ? inner.find('>') + 1 : begin);
  const double top = legend > 0 ? legend + 8 : 0;
  return svg_head(plot_width, height + top, plot.title, plot.description, dark) + keys +
         "<g transform=\"translate(0 " + fixed(top, 1) + ")\">\n" + inner.substr(0, inner.rfind("</svg>")) +
         "\n</g>\n</svg>\n";
}

std::string csv(const LinePlot& plot) {
  std::set<double> grid;
  std::vector<std::string> fields{plot.x.label};
  for (const PlotCurve& curve : plot.curves) {
    fields.push_back(curve.title);
    grid.insert(curve.x.begin(), curve.x.end());
  }
  std::string out;
  append_csv_row(out, fields);
  std::vector<std::size_t> next(plot.curves.size(), 0);
  for (const double x : grid) {
    fields.assign(1, number(x, 9));
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
      const PlotCurve& curve = plot.curves[i];
      std::string& field = fields.emplace_back();
      if (next[i] == curve.x.size() || curve.x[next[i]] != x) continue;
      if (std::isfinite(curve.y[next[i]])) field = number(curve.y[next[i]], 9);
      while (next[i] < curve.x.size() && curve.x[next[i]] == x) ++next[i];
    }
    append_csv_row(out, fields);
  }
  return out;
}

double value_at(const PlotCurve& curve, double x) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (curve.x.empty() || !(x >= curve.x.front() && x <= curve.x.back())) return none;
  const auto after = std::lower_bound(curve.x.begin(), curve.x.end(), x);
  const auto i = static_cast<std::size_t>(after - curve.x.begin());
  if (curve.x[i] == x) return curve.y[i];
  const double share = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
  return curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]);
}

}  // namespace etak
