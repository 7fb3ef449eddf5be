// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "core/spectrum/cie.h"

namespace etak {

// Observers and illuminants of one's own, as further values of Observer and Illuminant: name() of them is "own", and
// every function that takes a Viewing takes them. A value means its table as long as the pointer to it lives.

/// An illuminant by its relative power on the reference grid, no unit. Throws Error (naming "illuminant") for power that is
/// not finite, negative, or 0 everywhere.
std::shared_ptr<const Illuminant> own_illuminant(std::span<const double, grid_size> power);

/// An observer by x, y and z on the reference grid, no unit. Throws Error (naming "observer") for values that are not
/// finite, and for a sum of y that is not above 0.
std::shared_ptr<const Observer> own_observer(std::span<const std::array<double, 3>, grid_size> functions);

}  // namespace etak
