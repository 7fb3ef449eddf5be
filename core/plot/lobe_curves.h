// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/brdf/models.h"
#include "core/math/mat3.h"

namespace etak {

/// The BRDF of a model, or one of its terms, over an angle in the plane of incidence.
struct LobeCurve {
  std::vector<double> angle_deg;  // ascending; of a BRDF, that of the viewer from the normal, -90 (the
                                  // light's side) to 90
  std::vector<Vec3> rgb;          // f_r in 1/sr, or the term's value, at each angle
  double light_deg = 0;           // the light on the same scale: minus its angle from the normal
};

/// The curve of `model` for one direction of light. The mirror direction is among the angles.
///   values        the model's parameters, value_count() numbers
///   theta_l_deg   angle of the light from the normal, [0, 90)
///   step_deg      distance of the angles, changed to the nearest one that divides 180 evenly
LobeCurve lobe_curve(const Model& model, std::span<const double> values, double theta_l_deg,
                     double step_deg = 0.25);

/// The curve of one term: F over the angle of incidence, 0 to 90 degrees; D over the angle between half vector
/// and normal, 0 to 90; V over the angle of the viewer, as lobe_curve() has it.
///   values        the term's parameters, number_count() numbers
///   theta_l_deg   as above; used for V alone
///   step_deg      as above; of F and D, one that divides 90
LobeCurve term_curve(const Term& term, std::span<const double> values, double theta_l_deg, double step_deg);

}  // namespace etak
