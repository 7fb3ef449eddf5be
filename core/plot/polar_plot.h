// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/plot/plot_file.h"

namespace etak {

/// How far from the centre a value is drawn.
enum class RadialScale { linear, logarithmic };

/// A half disc over a surface: angles from -90 to 90 degrees against the normal, values outwards.
///   radial     for logarithmic ones all ticks are powers of ten; what is at or below its least is the centre
///   light_deg  the direction that light comes from
struct PolarPlot {
  std::string title, description;
  PlotAxis radial;
  RadialScale scale = RadialScale::linear;
  std::vector<PlotCurve> curves;  // x: angle in degrees, ascending; y: value
  std::vector<PlotKey> keys;
  double light_deg = 0;
};

/// The radial axis for values up to `most`: from 0, or four decades.
PlotAxis radial_axis(std::string label, double most, RadialScale scale);

/// The number at a tick of the radial axis.
std::string radial_text(const PolarPlot& plot, double tick);

/// Where a value lies between the centre (0) and the rim (1).
double polar_radius(const PolarPlot& plot, double value);

/// In units of the rim's radius: x to the right, y up.
struct PolarPoint {
  double x = 0, y = 0;
};
PolarPoint polar_point(const PolarPlot& plot, double angle_deg, double value);

std::string svg_file(const PolarPlot& plot, bool dark);
/// angle_deg, then a column per curve.
std::string csv(const PolarPlot& plot);

}  // namespace etak
