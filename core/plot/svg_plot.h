// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// One axis of a plot, from `least` to `most`, with a tick and a number at each of `ticks`.
struct PlotAxis {
  std::string label;  // with unit
  double least = 0, most = 1;
  std::vector<double> ticks;
};

/// An axis that holds [least, most] between round numbers, with about `count` ticks 1, 2 or 5 times a power
/// of ten apart. It starts at 0 when all values are above 0 and the least is under half of the largest. Equal
/// or non-finite ends give an axis of some width.
PlotAxis nice_axis(std::string label, double least, double most, int count = 5);

/// The number at a tick of an axis.
std::string tick_text(const PlotAxis& axis, double tick);

/// A line over x; NaN in y breaks it.
///   css_class   class of its path: the page's style sheet gives colour, width and dashes
///   title       what a pointer over it shows
///   dots        a mark at every point instead of a line
struct PlotCurve {
  std::vector<double> x, y;
  std::string css_class;
  std::string title;
  bool on_right = false;
  bool dots = false;
};

/// An entry of the legend; without a class it is text alone.
///   brief   said where there is no room for the text; empty: the text
struct PlotKey {
  std::string css_class, text;
  std::string brief = {};
};

/// A line plot for HTML pages.
///   title         accessible name
///   description   what the plot shows in a sentence, for those who cannot see it
///   strip         paint of a thin bar below the x axis ("url(#spectrum)"); may be empty
struct LinePlot {
  std::string title, description;
  PlotAxis x, left;
  std::optional<PlotAxis> right;
  std::vector<PlotCurve> curves;
  std::vector<PlotKey> keys;
  std::string strip;
};

/// The plot as an inline <svg> element, 460 x 270 units, coordinates with one decimal. Lines keep at most 120
/// points: those whose removal would move the line by less than a fifth of a unit are left out first (Ramer
/// 1972, Douglas and Peucker 1973).
std::string svg(const LinePlot& plot);

/// The rules svg() relies on, for the page's style sheet; colours come from the custom properties --ink,
/// --ink-soft, --line and --plot-1, --plot-2, ...
std::string_view plot_css();

}  // namespace etak
