// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/spectrum/integration.h"

namespace etak {

/// How Method::automatic chooses: sums of 20, 10, 5 and 1 nm, and the error of each of them for a spectrum,
/// estimated before the sum is taken.
///
/// A spectrum made of straight pieces is a constant, a slope and one hinge max(0, wavelength - knot) per
/// knot, as high as the slope changes there. The error of a rule for a hinge is known for every knot, so
/// the error of the sum is at most the sum of the errors of its hinges. Between knots a
/// spectrum bends (R is not linear where n and k are), so that hinges stand at places of etak's own too, on
/// the worst ones for the fine rules: 2.5 nm beside their points.
class Refinement {
 public:
  explicit Refinement(Viewing viewing);

  /// A rule of the ladder; R = 1 gives the X, Y and Z of the exact integral under each of them.
  struct Step {
    Method method;
    Quadrature rule;
  };
  std::span<const Step> steps() const { return steps_; }

  /// Where estimate() wants to know the reflectance: the knots inside 360..830 nm, the ends, and a place
  /// every 5 nm between; ascending.
  ///   knots_nm   ascending
  static std::vector<double> places(std::span<const double> knots_nm);

  /// The largest error of X, Y and Z that each step may have, in the order of steps(). An estimate: a bound
  /// where the reflectance is straight between the places.
  std::vector<double> estimate(std::span<const double> places_nm, std::span<const double> reflectance) const;

 private:
  // Sums over all that lies above a wavelength: of the weights, and of weight x distance.
  struct Above {
    std::array<double, 3> weight{}, moment{};
    std::array<std::array<double, 3>, 3> bend{};  // exact only: of the next nanometre, with t^2, t^3, t^4
  };
  std::array<double, 3> exact_hinge(double nm) const;
  std::array<double, 3> summed_hinge(std::size_t step, double nm) const;

  std::vector<Step> steps_;
  std::vector<Above> exact_;              // at every nanometre
  std::vector<std::vector<Above>> sums_;  // per step, at each of its points
};

/// The smallest distance between neighbours inside 360..830 nm; infinite below two.
double finest_spacing_nm(std::span<const double> knots_nm);

}  // namespace etak
