// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/brdf/models.h"

namespace etak {

/// A density of half vectors that follows the lobe of a model, for importance sampling: the share of the reflected
/// light that comes by way of each polar angle of the half vector, as a mean over eight views. One code serves every
/// distribution, since the share is summed from f_r itself; the azimuth is uniform, so that of an anisotropic lobe
/// only the mean over the azimuth is followed. A hundredth of the density is spread over the hemisphere, so that no
/// direction is left out that a model lights.
class LobeDensity {
 public:
  LobeDensity(const Model& model, const std::vector<double>& values);

  /// The polar angle of the half vector, in radians, for a number in [0, 1).
  double polar(double u) const;

  /// The density of half vectors at a polar angle, in 1/sr of half vectors. The density of the mirrored directions
  /// is this over 4 lh.
  double pdf(double polar) const;

 private:
  // The density over the polar angle and its integral, at the angles of nodes(); linear between them.
  std::vector<double> density_, sum_;
};

/// The values of a model with all diffuse colours set to 0, which leaves the specular part of one of kind both.
std::vector<double> without_body(const Model& model, std::vector<double> values);

}  // namespace etak
