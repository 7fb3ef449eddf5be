// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/brdf/models.h"
#include "core/math/mat3.h"

namespace etak {

/// A model in the plane of incidence.
struct LobeCurve {
  std::vector<double> angle_deg;  // of the viewer against the normal, -90 (the light's side) to 90, ascending
  std::vector<Vec3> rgb;          // f_r, 1/sr
  double light_deg = 0;           // where the light is: minus its angle
};

/// f_r of `model` for light at `theta_l_deg` from the normal, [0, 90). The mirror direction is among the
/// angles.
///   values   the model's parameters, value_count() numbers
LobeCurve lobe_curve(const Model& model, std::span<const double> values, double theta_l_deg,
                     double step_deg = 0.25);

}  // namespace etak
