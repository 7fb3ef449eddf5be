// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/brdf/models.h"
#include "core/math/mat3.h"

namespace etak {

/// The BRDF of a model over the angle of the viewer, in the plane of incidence.
struct LobeCurve {
  std::vector<double> angle_deg;  // of the viewer from the normal, -90 (the light's side) to 90, ascending
  std::vector<Vec3> rgb;          // f_r at each angle, 1/sr
  double light_deg = 0;           // the light on the same scale: minus its angle from the normal
};

/// The curve of `model` for one direction of light. The mirror direction is among the angles.
///   values        the model's parameters, value_count() numbers
///   theta_l_deg   angle of the light from the normal, [0, 90)
///   step_deg      distance of the angles, changed to the nearest one that divides 180 evenly
LobeCurve lobe_curve(const Model& model, std::span<const double> values, double theta_l_deg,
                     double step_deg = 0.25);

}  // namespace etak
