// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/spectrum/spectrum.h"

namespace etak {

/// CIE standard colorimetric observers, 1 nm, 360..830 nm (tables in resources/cie).
enum class Observer { cie1931_2deg, cie1964_10deg };

/// CIE illuminants, 5 nm, linear between entries as CIE prescribes; E is 1 everywhere.
enum class Illuminant { d65, d50, a, e };

std::string_view name(Observer observer);      // "1931-2deg", "1964-10deg"
std::string_view name(Illuminant illuminant);  // "D65", "D50", "A", "E"
std::optional<Observer> observer_named(std::string_view text);
std::optional<Illuminant> illuminant_named(std::string_view text);

/// Under which light and for whose eye a spectrum becomes a colour.
struct Viewing {
  Observer observer = Observer::cie1931_2deg;
  Illuminant illuminant = Illuminant::d65;
  friend bool operator==(const Viewing&, const Viewing&) = default;
};

/// x̄, ȳ, z̄ on the reference grid, no unit.
std::span<const std::array<double, 3>, grid_size> matching_functions(Observer observer);

/// Relative spectral power on the reference grid, no unit.
std::span<const double, grid_size> relative_power(Illuminant illuminant);

}  // namespace etak
