// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/light/functions.h"

// The tables of functions, one for each subject, and the inputs that several functions have; for
// functions*.cpp only.
namespace etak::function_rows {

std::span<const Function> fresnel();
std::span<const Function> films();
std::span<const Function> distributions();
std::span<const Function> reflectance();
std::span<const Function> lighting();

/// The complex index n + ik of a medium, relative to the outside.
struct Medium {
  double n, k;
};

/// The medium of this index. Throws Error for n = k = 0, which lets no wave through; in a table it stands for
/// a missing number. n = 0 with k > 0 is allowed: a metal without loss.
Medium medium(double index, double extinction);

inline constexpr double largest = 1e300;
inline constexpr FunctionInput n{"n", "index of refraction, relative to the outside", "", 0, 1e4};
inline constexpr FunctionInput k{"k", "extinction", "", 0, 1e6};
inline constexpr FunctionInput cosine{"cos", "cosine; taken as 0 below 0", "", -1, 1};
inline constexpr FunctionInput f0{"f0", "reflectance at normal incidence", "", -10, 10};
inline constexpr FunctionInput K{"K", "specular colour; taken as 0 below 0", "", -10, 10};
inline constexpr FunctionInput g{"g", "gloss; the lobe's exponent is 2^(12 g)", "", 0, 1};
inline constexpr FunctionInput alpha{"alpha", "width", "", 1e-100, 100};
inline constexpr FunctionInput m{"m", "rms slope", "", 1e-100, 100};
inline constexpr FunctionInput e{"e", "exponent", "", 0, 1e9};
inline constexpr FunctionInput theta_l{"theta_l", "polar angle of the light", "deg", 0, 180};
inline constexpr FunctionInput theta_v{"theta_v", "polar angle of the viewer", "deg", 0, 180};
inline constexpr FunctionInput phi_v{"phi_v", "azimuth of the viewer; 0 is the light's, 180 the mirror side",
                                     "deg", -3600, 3600};

}  // namespace etak::function_rows
