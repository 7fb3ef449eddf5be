// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "core/math/mat3.h"

namespace etak {

/// The largest CIEDE2000 between two forms of F, D65, looked for at 97 even steps of the square root of the cosine, and
/// where it is.
struct FresnelDifference {
  double de2000 = 0, at_deg = 0;
  friend bool operator==(const FresnelDifference&, const FresnelDifference&) = default;
};

/// F over the angle of incidence as a curve through colours (core/fresnel/curve.glsl), linear sRGB.
///   off   between the curve and what it was fitted to
struct FresnelCurve {
  static constexpr std::size_t count = 16;
  std::array<Vec3, count> colors{};
  FresnelDifference off;
  friend bool operator==(const FresnelCurve&, const FresnelCurve&) = default;

  ///   cosine   of incidence, [0, 1]
  Vec3 at(double cosine) const;
};

/// The curve of least squares. Its error is that of F itself: a stack whose fringes are too narrow for 16 colours has a
/// large one.
///   seen   F at a cosine of incidence in [0, 1], linear sRGB
FresnelCurve fitted_curve(const std::function<Vec3(double cosine)>& seen);

FresnelDifference fresnel_difference(const std::function<Vec3(double cosine)>& a,
                                     const std::function<Vec3(double cosine)>& b);

}  // namespace etak
