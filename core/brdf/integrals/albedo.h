// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "core/brdf/models.h"
#include "core/math/mat3.h"

namespace etak {

/// The unit vector at polar angle theta from +z and azimuth phi from +x, both in degrees. It is exact at
/// multiples of 90 degrees.
Vec3 direction_deg(double theta_deg, double phi_deg);

/// A function that gives f_r of one channel, in 1/sr.
using BrdfFunction = std::function<double(const Directions&)>;

/// Settings of the integral of an albedo: what it should know of the function, and the error that it may have.
struct AlbedoOptions {
  // Width of the lobe in the half vector's polar angle, radians. The integrand is sampled most densely there.
  double lobe_width = 0.1;
  double error = 1e-8;    // the error asked for, relative to the albedo or to 1, whichever is greater
  bool isotropic = true;  // f does not change when both directions turn about the normal
  // Where given, only light l with dot(l, half_space) > 0 counts.
  std::optional<Vec3> half_space;
};

/// Directional albedo: the integral of f nl over the hemisphere of light, for a viewer at polar angle theta_v
/// and azimuth 0. It is taken over half vectors, in pieces that end at the horizon and at the edges of
/// V-groove shadowing, so that lobes of exponent 4096 and views at 89.9 degrees are as accurate as all
/// others.
double directional_albedo(const BrdfFunction& f, double theta_v_deg, const AlbedoOptions& options);

/// The integral of D nm over the hemisphere.
///   D            the distribution, a function of nm and s2 = 1 - nm^2
///   lobe_width   width of D in the polar angle, radians
///   error        below 1e-10
double integral_of_distribution(const std::function<double(double nm, double s2)>& D, double lobe_width);

/// The largest directional albedo of the qualitative Oren-Nayar model for rho = 1, over all sigma and angles.
/// It is reached at grazing view, where the albedo is A + B / 2.
double oren_nayar_grazing_albedo_max();

}  // namespace etak
