// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "core/spectrum/cie.h"
#include "core/spectrum/spectrum.h"

namespace etak {

// Observers and illuminants of one's own, as further values of Observer and Illuminant: name() of them is the
// label that they were given, and every function that takes a Viewing takes them. A value means its table as long as the pointer to it lives.

/// An illuminant by its relative power on the reference grid, no unit. Throws Error (naming `place`) for power that is
/// not finite, negative, or 0 everywhere.
std::shared_ptr<const Illuminant> own_illuminant(std::span<const double, grid_size> power,
                                                 std::string label = "own",
                                                 const std::string& place = "illuminant");
/// An illuminant from a table, linear between its rows and 0 beyond them. Throws Error (naming `place`) as
/// own_illuminant() does, and where the table does not hold 380-780 nm.
std::shared_ptr<const Illuminant> illuminant_of_table(const Spectrum& power, const std::string& place,
                                                      std::string label = "own");

/// An observer by x, y and z on the reference grid, no unit. Throws Error (naming `place`) for values that are not
/// finite, and for a sum of y that is not above 0.
std::shared_ptr<const Observer> own_observer(std::span<const std::array<double, 3>, grid_size> functions,
                                             std::string label = "own",
                                             const std::string& place = "observer");
std::shared_ptr<const Observer> observer_of_table(const std::array<Spectrum, 3>& functions,
                                                  const std::string& place, std::string label = "own");

/// What is to be known of colours under a light, as a part of a sentence; empty: nothing. A light of lines (nine tenths
/// of its power within 40 nm, as of lasers and lamps of lines) shows surfaces as no other light does; a metamer of D65,
/// D50, A or E has its colour by another spectrum, so that what matches under one need not match under the other.
std::string light_remark(Illuminant illuminant);

}  // namespace etak
