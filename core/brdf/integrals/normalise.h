// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/brdf/models.h"

namespace etak {

/// The constant c of the ABC distribution in 1/sr: the integral of c (1 + a1 (1 - nm))^-a2 nm over the
/// hemisphere is 1. Hoffman prints the distribution without it.
///   a1, a2   >= 0, finite
///   error    relative below 1e-12, also near a2 = 1, 2 and for a1 -> 0
double abc_norm(double a1, double a2);

/// The natural logarithm of 1 / Gamma(1 - p, alpha), the constant of the shifted gamma distribution (Bagher
/// et al. 2012).
///   alpha, p   > 0
///   error      of the constant: relative below 1e-11
double log_sgd_norm(double alpha, double p);

}  // namespace etak
