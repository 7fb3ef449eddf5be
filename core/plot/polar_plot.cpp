// SPDX-License-Identifier: Apache-2.0
#include "core/plot/polar_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/math/functions.h"
#include "core/plot/plot_file.h"

namespace etak {
namespace {

constexpr double rim = 190, side = 40;
constexpr double decades = 4;

PolarPoint on_rim(double angle_deg, double radius) {
  const double radian = angle_deg * std::numbers::pi / 180;
  return {radius * math::sin(radian), radius * math::cos(radian)};
}

}  // namespace

PlotAxis radial_axis(std::string label, double most, RadialScale scale) {
  if (!(most > 0) || !std::isfinite(most)) most = 1;
  if (scale == RadialScale::linear) return nice_axis(std::move(label), 0, most, 4);
  PlotAxis out;
  out.label = std::move(label);
  const double last = std::ceil(math::log10(most) - 1e-9);
  for (double power = last - decades; power <= last; ++power) out.ticks.push_back(math::pow(10, power));
  out.least = out.ticks.front();
  out.most = out.ticks.back();
  return out;
}

std::string radial_text(const PolarPlot& plot, double tick) {
  return plot.scale == RadialScale::linear ? tick_text(plot.radial, tick) : number(tick, 6);
}

double polar_radius(const PolarPlot& plot, double value) {
  const PlotAxis& axis = plot.radial;
  if (!(value > axis.least)) return 0;
  const double share = plot.scale == RadialScale::linear
                           ? (value - axis.least) / (axis.most - axis.least)
                           : math::log10(value / axis.least) / math::log10(axis.most / axis.least);
  return std::min(share, 1.0);
}

PolarPoint polar_point(const PolarPlot& plot, double angle_deg, double value) {
  return on_rim(angle_deg, polar_radius(plot, value));
}

std::string svg_file(const PolarPlot& plot, bool dark) {
  double legend = 0;
  const std::string keys = svg_legend(plot.keys, 10, 6, plot_width - 20, legend);
  const double cx = plot_width / 2, cy = legend + side + rim;
  const auto at = [&](PolarPoint p) { return fixed(cx + rim * p.x, 1) + " " + fixed(cy - rim * p.y, 1); };
  std::string out = svg_head(plot_width, cy + 40, plot.title, plot.description, dark) + keys;
  std::string grid;
  for (const double tick : plot.radial.ticks) {
    const double r = rim * polar_radius(plot, tick);
    if (r > 0)
      append(grid, "M", fixed(cx - r, 1), " ", fixed(cy, 1), "A", fixed(r, 1), " ", fixed(r, 1), " 0 0 1 ",
             fixed(cx + r, 1), " ", fixed(cy, 1));
  }
  for (int angle = -60; angle <= 60; angle += 30) append(grid, "M", at({0, 0}), "L", at(on_rim(angle, 1)));
  append(out, "<path class=\"grid\" d=\"", grid, "\"/>\n<path class=\"axis\" d=\"M", at({-1, 0}), "L",
         at({1, 0}), "\"/>\n");
  for (int angle = -90; angle <= 90; angle += 30) {
    const PolarPoint p = on_rim(angle, 1.06);
    append(out, "<text x=\"", fixed(cx + rim * p.x, 1), "\" y=\"",
           fixed(cy - rim * p.y + (angle % 90 == 0 ? 4 : 0), 1), "\" text-anchor=\"",
           angle < 0   ? "end"
           : angle > 0 ? "start"
                       : "middle",
           "\">", std::to_string(std::abs(angle)), "°</text>\n");
  }
  for (const double tick : plot.radial.ticks)
    append(out, "<text x=\"", fixed(cx + rim * polar_radius(plot, tick), 1), "\" y=\"", fixed(cy + 15, 1),
           "\" text-anchor=\"middle\">", radial_text(plot, tick), "</text>\n");
  append(out, "<text class=\"label\" x=\"", fixed(cx, 1), "\" y=\"", fixed(cy + 32, 1),
         "\" text-anchor=\"middle\">", escape_html(plot.radial.label), "</text>\n<path class=\"axis\" d=\"M",
         at(on_rim(plot.light_deg, 1)), "L", at(on_rim(plot.light_deg, 0.8)), "\" stroke-width=\"3\"/>\n");
  for (const PlotCurve& curve : plot.curves) {
    append(out, "<path class=\"curve ", escape_html(curve.css_class), "\" d=\"");
    bool begun = false;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!std::isfinite(curve.y[i])) {
        begun = false;
        continue;
      }
      append(out, begun ? "L" : "M", at(polar_point(plot, curve.x[i], curve.y[i])));
      begun = true;
    }
    append(out, "\"><title>", escape_html(curve.title), "</title></path>\n");
  }
  return out + "</svg>\n";
}

std::string csv(const PolarPlot& plot) {
  LinePlot lines;
  lines.x.label = "angle_deg";
  lines.curves = plot.curves;
  return csv(lines);
}

}  // namespace etak
