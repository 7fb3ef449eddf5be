// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"
#include "core/math/mat3.h"

namespace etak {

/// What the eye sees of light whose reflectance goes through one wave over the wavenumber: the Fourier transform of the
/// matching functions of CIE 1931 under equal energy, as sums of Gaussians, XYZ.
///   path_nm   optical path difference
///   shift     phase of each of X, Y and Z, radians
///   from      Belcour and Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying
///             Iridescence", the fit of their supplemental code
inline Vec3 wave_seen(double path_nm, const Vec3& shift) {
  constexpr Vec3 height{5.4856e-13, 4.4201e-13, 5.2481e-13}, position{1.6810e6, 1.7953e6, 2.2084e6},
      variance{4.3278e9, 9.3046e9, 6.6121e9};
  constexpr double blue_height = 9.7470e-14, blue_position = 2.2399e6, blue_variance = 4.5282e9,
                   all = 1.0685e-7;
  const double phase = 2 * std::numbers::pi * path_nm * 1e-9;
  const auto bump = [&](double high, double at, double wide, double by) {
    return high * std::sqrt(2 * std::numbers::pi * wide) * math::cos(at * phase + by) *
           math::exp(-wide * phase * phase);
  };
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = bump(height[i], position[i], variance[i], shift[i]);
  out[0] += bump(blue_height, blue_position, blue_variance, shift[0]);
  return scaled(out, 1 / all);
}

}  // namespace etak
