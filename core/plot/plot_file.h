// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/plot/svg_plot.h"

namespace etak {

// For plots outside of etak's HTML pages: colours, SVG and CSV files, the value of a curve at a place.

/// The look of a PlotCurve.
///   css_class   words with blanks between them: "c1" to "c9" for the colour, "bold", "dots", and one of
///               "dashed", "dotted" and "dashdot"; other words are ignored
struct PlotStyle {
  std::size_t color = 0;  // index into PlotColors::series
  bool bold = false, dots = false;
  enum class Dash { none, dashed, dotted, dashdot } dash = Dash::none;
};
PlotStyle plot_style(std::string_view css_class);

/// The colours of a plot as "#rrggbb", on a light or a dark background. All but the series are neutral greys,
/// because colours that are to be judged may stand beside the plot.
struct PlotColors {
  std::string_view background, ink, ink_soft, line;
  std::string_view series[9];
};
const PlotColors& plot_colors(bool dark);

/// A plot as an SVG file. Its own style sheet holds the colours; the legend stands in rows above the plot.
std::string svg_file(const LinePlot& plot, bool dark);

/// The curves as CSV: a column of x, then a column for each curve under its title. A field is empty where the
/// curve has no value.
std::string csv(const LinePlot& plot);

/// y of a curve at x, on straight lines between its points; NaN outside of them and where the curve is
/// interrupted. The curve's x must ascend.
double value_at(const PlotCurve& curve, double x);

// The parts of SVG files that all kinds of plots share.

/// Width of every plot in user units of SVG. A file is shown at two pixels a unit.
inline constexpr double plot_width = 460;

/// The legend as SVG: for each entry a sample of its line and its text, in rows from (left, top) on that are
/// at most `width` wide. `height` is set to the height of all rows. All numbers are in user units.
std::string svg_legend(const std::vector<PlotKey>& keys, double left, double top, double width,
                       double& height);
/// The beginning of an SVG file: the opening tag, title, description, style sheet and background.
std::string svg_head(double width, double height, std::string_view title, std::string_view description,
                     bool dark);

}  // namespace etak
