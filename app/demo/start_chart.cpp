// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "app/demo/start_page.h"
#include "core/base/number.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

constexpr double chart_width = 640, chart_height = 380;
constexpr double chart_left = 60, chart_right = 620, chart_top = 34, chart_bottom = 326;
constexpr double least_drawn = 1e-3;  // smaller errors are drawn here: nobody sees them

// A logarithmic axis that holds `least` and `most` with room at its ends.
struct ChartAxis {
  double first, last;  // log10
  double from, to;     // coordinates

  double at(double value) const {
    return from + (std::log10(std::max(value, least_drawn)) - first) / (last - first) * (to - from);
  }
};

ChartAxis chart_axis(double least, double most, double from, double to) {
  return {std::log10(std::max(least, least_drawn)) - 0.15, std::log10(std::max(most, least_drawn)) + 0.15,
          from, to};
}

// The numbers 1, 2 and 5 times a power of ten on the axis.
std::vector<double> chart_ticks(const ChartAxis& axis) {
  std::vector<double> out;
  for (double decade = std::floor(axis.first); decade <= axis.last; ++decade)
    for (const double mantissa : {1.0, 2.0, 5.0}) {
      const double value = mantissa * std::pow(10.0, decade);
      if (std::log10(value) >= axis.first && std::log10(value) <= axis.last) out.push_back(value);
    }
  return out;
}

std::string chart_place(double value) {
  return fixed(value, 1);
}

void append_chart_axes(std::string& out, const ChartAxis& x, const ChartAxis& y) {
  for (const double tick : chart_ticks(x)) {
    const std::string at = chart_place(x.at(tick));
    append(out, "<path class=\"grid\" d=\"M", at, ' ', chart_place(chart_top), 'V', chart_place(chart_bottom),
           "\"/><text x=\"", at, "\" y=\"", chart_place(chart_bottom + 18), "\" text-anchor=\"middle\">",
           number(tick, 3), "</text>");
  }
  for (const double tick : chart_ticks(y)) {
    const double at = y.at(tick);
    append(out, "<path class=\"grid\" d=\"M", chart_place(chart_left), ' ', chart_place(at), 'H',
           chart_place(chart_right), "\"/><text x=\"", chart_place(chart_left - 8), "\" y=\"",
           chart_place(at + 4), "\" text-anchor=\"end\">", number(tick, 3), "</text>");
  }
  append(out,
         "<text class=\"label\" x=\"8\" y=\"16\">mean ΔE2000 of a sphere against the measured one</text>",
         "<text class=\"label\" x=\"", chart_place((chart_left + chart_right) / 2), "\" y=\"",
         chart_place(chart_height - 12),
         "\" text-anchor=\"middle\">time of one evaluation, ns (logarithmic, like the error)</text>");
}

}  // namespace

std::string start_chart(std::span<const StartPoint> points) {
  if (points.empty()) return {};
  double shortest = points[0].ns, longest = points[0].ns, least = points[0].least_de,
         most = points[0].most_de;
  for (const StartPoint& point : points) {
    shortest = std::min(shortest, point.ns);
    longest = std::max(longest, point.ns);
    least = std::min(least, point.least_de);
    most = std::max(most, point.most_de);
  }
  // Half of the shortest time leaves room for a name at the left of its dot.
  const ChartAxis x = chart_axis(shortest / 2, longest, chart_left, chart_right);
  const ChartAxis y = chart_axis(least, most, chart_bottom, chart_top);
  std::string out = "<svg class=\"chart\" viewBox=\"0 0 ";
  append(out, chart_place(chart_width), ' ', chart_place(chart_height),
         "\" role=\"img\"><title>Error against time of ways to compute reflectance</title>");
  append_chart_axes(out, x, y);
  for (const StartPoint& point : points) {
    const double at = x.at(point.ns), middle = y.at(point.mean_de);
    // Names stand at the right of their dots, but not where the plot ends or another dot is near.
    const bool met = std::ranges::any_of(points, [&](const StartPoint& other) {
      const double dx = x.at(other.ns) - at, dy = y.at(other.mean_de) - middle;
      return dx > 0 && dx < 60 && std::abs(dy) < 18;
    });
    const bool on_left = met || at > (chart_left + 2 * chart_right) / 3;
    append(out, "<path class=\"reach\" d=\"M", chart_place(at), ' ', chart_place(y.at(point.most_de)), 'V',
           chart_place(y.at(point.least_de)), "\"/><circle cx=\"", chart_place(at), "\" cy=\"",
           chart_place(middle), "\" r=\"6\"><title>");
    append(out, escape_html(point.title), ": mean ", number(point.mean_de, 3), ", materials from ",
           number(point.least_de, 2), " to ", number(point.most_de, 3), ", ", number(point.ns, 3),
           " ns</title></circle>");
    append(out, "<text class=\"name\" x=\"", chart_place(at + (on_left ? -11 : 11)), "\" y=\"",
           chart_place(middle + 5), on_left ? "\" text-anchor=\"end\">" : "\">", escape_html(point.title),
           "</text>");
  }
  return out += "</svg>";
}

}  // namespace etak
