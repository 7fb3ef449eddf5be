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
/// of ten apart. It starts at 0 when all values are above 0 and the least is under half of the largest. Where
/// the ends are equal or not finite, the axis still has a width above 0.
PlotAxis nice_axis(std::string label, double least, double most, int count = 5);

/// The text at a tick of an axis.
std::string tick_text(const PlotAxis& axis, double tick);

/// A curve over x; NaN in y interrupts it.
///   css_class   class of its path: the page's style sheet gives colour, width and dashes
///   title       text that is shown when the pointer is over the curve
///   on_right    y belongs to the right axis, where the plot has one
///   dots        a mark at every point instead of a line
struct PlotCurve {
  std::vector<double> x, y;
  std::string css_class;
  std::string title;
  bool on_right = false;
  bool dots = false;
};

/// An entry of the legend: a sample of the line of `css_class`, and a text; without a class the text alone.
///   brief   a shorter text for places without room; empty: the text itself
struct PlotKey {
  std::string css_class, text;
  std::string brief = {};
};

/// A part of the x axis, with a text above it. Each zone behind the first is shaded more than the one before.
struct PlotZone {
  double first, last;
  std::string_view text;
};

/// A line plot for HTML pages.
///   title         accessible name
///   description   what the plot shows in a sentence, for those who cannot see it
///   zones         parts of the x axis; their texts need the place of the legend, which svg_file() moves away
///   strip         SVG paint of a thin bar below the x axis, such as "url(#spectrum)"; empty: no bar
struct LinePlot {
  std::string title, description;
  PlotAxis x, left;
  std::optional<PlotAxis> right;
  std::vector<PlotCurve> curves;
  std::vector<PlotKey> keys;
  std::string strip;
  std::vector<PlotZone> zones = {};
};

/// The plot as an inline <svg> element, 460 x 270 units, coordinates with one decimal. An uninterrupted line
/// keeps at most 120 points: those whose removal would move the line by less than a fifth of a unit are left
/// out first (Ramer 1972, Douglas and Peucker 1973).
std::string svg(const LinePlot& plot);

/// The CSS rules that svg() needs in the style sheet of the page. Colours come from the custom properties
/// --ink, --ink-soft, --line and --plot-1, --plot-2, ...
std::string_view plot_css();

}  // namespace etak
