// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/plot/f0_curves.h"
#include "core/plot/lobe_curves.h"
#include "core/plot/polar_plot.h"
#include "core/study/angle_curves.h"

namespace etak {

// Curves of one material as plots: axes, legend, what a reader is told.

/// n and k over wavelength, as published. Without curves for reflectance data.
LinePlot index_plot(const std::string& name, const OpticsCurves& curves);

/// Reflectance at 0 and 81.8 degrees over wavelength, with the observer's matching functions on the right.
LinePlot reflectance_plot(const std::string& name, const OpticsCurves& curves, Observer observer);

/// What of a colour a plot over angle shows.
enum class PlotChannel { red, green, blue, luminance };

/// F over the angle of incidence: exact, and every form with its largest error and the time of an evaluation.
LinePlot angle_plot(const std::string& name, const AngleCurves& curves, PlotChannel channel);

/// f_r in the plane of incidence; one curve where red, green and blue are the same.
PolarPlot lobe_plot(const std::string& name, const LobeCurve& lobe, RadialScale scale);

}  // namespace etak
