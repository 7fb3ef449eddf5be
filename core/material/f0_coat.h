// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/material/f0.h"

namespace etak {

/// A clear layer over a material (lacquer, varnish, water), thick enough that light reflected at its two sides does not
/// interfere.
///   label          as it was asked for: "1.5", "water:2mm"
///   medium         its n, and its k, which counts over `thickness_nm`
///   n              at helium's yellow line, 587.56 nm
///   thickness_nm   0: nothing is absorbed
struct Coat {
  std::string label;
  OpticalConstants medium;
  double n = 1, thickness_nm = 0;
};

/// What a coat, of that label and n, makes of a material. Each part has the colours of its spectrum, and no coverage and flags but those of
/// out-of-gamut and zone.
///   under         the base as light inside of the coat meets it: F0 is (N - n) / (N + n) squared, and F82 is at cosine
///                 1/7 in the coat, where a base's own F takes its angle. From outside light reaches cosines of
///                 sqrt(1 - (n_outside / n)^2) and more
///   whole         coat and base as they are seen from outside: the coat's surface, and all that goes up and down below
///                 it. F82 is at cosine 1/7 outside
///   energy_left   of what the base reflects at normal incidence under the coat, the share that gets out: at each
///                 wavelength F0 of the whole = S + energy_left x F0 under, S being F0 of the coat's surface. With A
///                 for the share that the coat's k leaves of light on its way down and up, it is
///                 A (1 - S)^2 / (1 - A S F0_under): OpenPBR's T (1 - E_coat) times its darkening for a smooth base.
///                 Without F82
///   passes        A, in the options' space
struct CoatedF0 {
  std::string label;
  double n = 1;
  F0Result under, whole, energy_left;
  LinearRgb passes;
  friend bool operator==(const CoatedF0&, const CoatedF0&) = default;
};

/// Coat, layers and base, the coat as the outermost layer.
Stack coated_stack(const Coat& coat, const Optics& optics);

/// Computes `out`. Returns why the data do not allow it. Throws Error (naming `place`) for reflectance at normal incidence
/// alone: many n and k have it, which a coat makes different.
std::string coated(const Coat& coat, const F0Options& options, const Optics& optics, const std::string& place,
                   CoatedF0& out);

}  // namespace etak
