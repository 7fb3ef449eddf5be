// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

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

/// F over the angle of incidence in degrees: the exact curve where the data give one, and every Fresnel form
/// with its largest error and the time of an evaluation.
LinePlot angle_plot(const std::string& name, const AngleCurves& curves, PlotChannel channel);

/// f_r in 1/sr in the plane of incidence; one curve where red, green and blue are the same.
PolarPlot lobe_plot(const std::string& name, const LobeCurve& lobe, RadialScale scale);

}  // namespace etak
