// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/fresnel_forms.h"

namespace etak {

/// One form of Fresnel reflectance over the angles of an AngleCurves.
struct AngleCurve {
  std::string_view id, title;  // of the form: "schlick", "Schlick"
  std::vector<Vec3> rgb;       // linear sRGB, unclipped
  FresnelError error;          // against the exact curve, over all channels and angles; 0 where there is none
  double ns = 0;               // time of one evaluation of one channel; 0: not measured
};

/// The Fresnel reflectance F of a material over the angle of incidence: exact, and by forms that shaders use.
struct AngleCurves {
  std::vector<double> angle_deg;  // 0 to 90, ascending
  std::vector<Vec3> exact;        // F(wavelength, angle) summed to linear sRGB; empty for reflectance data
  double exact_ns = 0;            // time of one angle, all wavelengths and channels; 0: not measured
  std::vector<AngleCurve>
      forms;  // Schlick, Schueler, F82, F82 tint and, of n and k, Lazanyi; where there is no
              // exact curve, only those that need F0 alone
};

/// The curves of a dataset, without times; empty where the data give no F0. Each form gets the numbers that a
/// renderer would have: F0, F82, or a fit for each channel. Throws Error as fresnel_truth() does.
///   options    observer, illuminant and outside medium are used
///   what       names the data in messages
///   step_deg   distance of the angles; errors are taken at these angles
AngleCurves angle_curves(const Optics& optics, const F0Options& options, std::string_view what,
                         double step_deg = 0.5);

/// Measures `ns` of every form, and exact_ns, in this process: the median of interleaved short loops over
/// cosines that are the same in every run. It takes about 20 ms, too long for a thread that draws.
void time_angle_curves(AngleCurves& curves);

}  // namespace etak
