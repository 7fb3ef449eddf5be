// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/plot/f0_curves.h"
#include "core/plot/lobe_curves.h"
#include "core/plot/polar_plot.h"
#include "core/study/angle_curves.h"

namespace etak {

// Curves of one material as plots with axes, legend and a description in words.

/// n and k over wavelength in nm, as published. Reflectance data have neither: the plot then has no curves.
LinePlot index_plot(const std::string& name, const OpticsCurves& curves);

/// Reflectance at 0 and 81.8 degrees over wavelength in nm (left axis), and the colour-matching functions of
/// the observer (right axis).
LinePlot reflectance_plot(const std::string& name, const OpticsCurves& curves, Observer observer);

/// The part of a colour that a plot over angle shows.
enum class PlotChannel { red, green, blue, luminance };
inline constexpr std::array<std::string_view, 4> plot_channels{"red", "green", "blue", "luminance"};

/// F over the angle of incidence in degrees: the exact curve where the data give one, and every Fresnel form
/// with its largest error and the time of an evaluation.
LinePlot angle_plot(const std::string& name, const AngleCurves& curves, PlotChannel channel);

/// What a plot of several materials, models or terms shows: a term of microfacet models (masking: G, that is
/// V times 4 nl nv), f_r nl in the plane of incidence, or reflectance over wavelength.
enum class CurveKind { fresnel, distribution, masking, visibility, lobe, reflectance };

/// A curve of such a plot, in linear sRGB. All channels are the same where the quantity has no colour.
struct ColorCurve {
  std::string title;
  std::vector<double> x;
  std::vector<Vec3> rgb;
};

/// The plot of several curves. F has Hoffman's zones: up to 45 degrees it barely changes, then it changes, and
/// from 75 degrees on it rushes to white. Throws Error where more curves are asked for than can be told apart.
///   channels    of each curve; a curve of which all channels are the same is drawn once
///   light_deg   angle of the light from the normal, where the kind has one
LinePlot curves_plot(CurveKind kind, const std::vector<ColorCurve>& curves,
                     std::span<const PlotChannel> channels, double light_deg);

/// The curves of a plot around the normal.
PolarPlot polar_plot(const LinePlot& plot, double light_deg, RadialScale scale);

/// The curves as JSON, etak-curve/1.
///   of   the kind as the command line names it
std::string curves_json(const LinePlot& plot, std::string_view of);

/// f_r in 1/sr in the plane of incidence; one curve where red, green and blue are the same.
PolarPlot lobe_plot(const std::string& name, const LobeCurve& lobe, RadialScale scale);

}  // namespace etak
