// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "core/brdf/models.h"
#include "core/math/mat3.h"

namespace etak {

/// Direction at polar angle theta from +z and azimuth phi from +x, in degrees; exact at multiples of 90.
Vec3 direction_deg(double theta_deg, double phi_deg);

/// f_r of one channel, in 1/sr.
using BrdfFunction = std::function<double(const Directions&)>;

struct AlbedoOptions {
  double lobe_width = 0.1;  // of the half vector's angle, radians: where the integrand is looked at closest
  double error = 1e-8;      // wanted, relative to the albedo or to 1, whichever is greater
  bool isotropic = true;    // f does not change with a turn about the normal
  std::optional<Vec3> half_space;  // only light with l . this > 0
};

/// Directional albedo: integral of f nl over the hemisphere of light, for a viewer at theta_v and azimuth 0.
/// Integrated over half vectors, with the horizon and the edges of V-groove shadowing as ends of the pieces,
/// so that lobes of exponent 4096 and views of 89.9 degrees come out as surely as the rest.
double directional_albedo(const BrdfFunction& f, double theta_v_deg, const AlbedoOptions& options);

/// Integral of D nm over the hemisphere.
///   D       of nm and s2 = 1 - nm^2
///   error   below 1e-10
double integral_of_distribution(const std::function<double(double nm, double s2)>& D, double lobe_width);

/// The largest directional albedo of the qualitative Oren-Nayar model over sigma and angle, for rho = 1: at
/// grazing view, where it is A + B / 2.
double oren_nayar_grazing_albedo_max();

}  // namespace etak
