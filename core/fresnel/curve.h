// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "core/math/mat3.h"

namespace etak {

/// F over the angle of incidence as a curve through colours (core/fresnel/curve.glsl), linear sRGB.
///   error    the largest CIEDE2000 between the curve and what it was fitted to, D65; looked for at 97 even steps of the
///            square root of the cosine
///   at_deg   where it is
struct FresnelCurve {
  static constexpr std::size_t count = 16;
  std::array<Vec3, count> colors{};
  double error = 0, at_deg = 0;
  friend bool operator==(const FresnelCurve&, const FresnelCurve&) = default;

  ///   cosine   of incidence, [0, 1]
  Vec3 at(double cosine) const;
};

/// The curve of least squares. Its error is that of F itself: a stack whose fringes are too narrow for 16 colours has a
/// large one.
///   seen   F at a cosine of incidence in [0, 1], linear sRGB
FresnelCurve fitted_curve(const std::function<Vec3(double cosine)>& seen);

/// The largest CIEDE2000 between two forms of F, and where it is, as in FresnelCurve.
struct FresnelDifference {
  double de2000 = 0, at_deg = 0;
};
FresnelDifference fresnel_difference(const std::function<Vec3(double cosine)>& a,
                                     const std::function<Vec3(double cosine)>& b);

}  // namespace etak
