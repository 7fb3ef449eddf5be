// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/plot/plot_file.h"

namespace etak {

/// How the distance from the centre grows with the value.
enum class RadialScale { linear, logarithmic };

/// A polar plot on a half disc: its angle is the one from a surface's normal, -90 to 90 degrees, and the
/// distance from the centre stands for the value.
///   radial      axis of the values: values at or below `least` are drawn at the centre; the ticks of a
///               logarithmic axis are powers of ten
///   light_deg   angle of the direction that light comes from, in degrees
struct PolarPlot {
  std::string title, description;
  PlotAxis radial;
  RadialScale scale = RadialScale::linear;
  std::vector<PlotCurve> curves;  // x: angle in degrees, ascending; y: value
  std::vector<PlotKey> keys;
  double light_deg = 0;
};

/// The radial axis for values up to `most`: a linear one begins at 0, a logarithmic one covers four decades.
PlotAxis radial_axis(std::string label, double most, RadialScale scale);

/// The text at a tick of the radial axis.
std::string radial_text(const PolarPlot& plot, double tick);

/// The distance of a value from the centre: 0 at the centre, 1 at the rim and for values beyond the axis.
double polar_radius(const PolarPlot& plot, double value);

/// A point of the half disc in units of the rim's radius: x to the right, y up.
struct PolarPoint {
  double x = 0, y = 0;
};
PolarPoint polar_point(const PolarPlot& plot, double angle_deg, double value);

/// The plot as an SVG file, the legend in rows above it.
std::string svg_file(const PolarPlot& plot, bool dark);
/// The curves as CSV: a column "angle_deg", then a column for each curve under its title.
std::string csv(const PolarPlot& plot);

}  // namespace etak
