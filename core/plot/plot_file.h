// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/plot/svg_plot.h"

namespace etak {

// What a plot needs outside of etak's own HTML pages: colours, a file of its own, numbers.

/// The look that the classes of a PlotCurve ask for: "c1" to "c9" the colour, "bold", "dots", and one of
/// "dashed", "dotted", "dashdot".
struct PlotStyle {
  std::size_t color = 0;  // into PlotColors::series
  bool bold = false, dots = false;
  enum class Dash { none, dashed, dotted, dashdot } dash = Dash::none;
};
PlotStyle plot_style(std::string_view css_class);

/// "#rrggbb"; neutral greys, because judged colours stand beside them.
struct PlotColors {
  std::string_view background, ink, ink_soft, line;
  std::string_view series[9];
};
const PlotColors& plot_colors(bool dark);

/// A plot as an SVG file: colours written out, the legend in rows above the plot.
std::string svg_file(const LinePlot& plot, bool dark);

/// The numbers of the curves: x, then a column per curve by its title; empty where a curve has no value.
std::string csv(const LinePlot& plot);

/// y of a curve at x: linear between its points; NaN outside of them and where it is broken. x ascending.
double value_at(const PlotCurve& curve, double x);

// For the other kinds of plots.

/// Width of every plot in the user units of SVG, which are pixels at a browser's usual size.
inline constexpr double plot_width = 460;

/// Rows of legend entries "sample text" as SVG, from (left, top) on, no wider than `width`; `height` is what
/// they take.
std::string svg_legend(const std::vector<PlotKey>& keys, double left, double top, double width,
                       double& height);
/// The head of an SVG file with its style sheet.
std::string svg_head(double width, double height, std::string_view title, std::string_view description,
                     bool dark);

}  // namespace etak
