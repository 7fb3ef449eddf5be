// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>

#include "core/brdf/models.h"

namespace etak {

/// A list of at most sixteen items as a compile-time constant, for the rows of the registry.
template <class T>
class Few {
 public:
  constexpr Few(std::initializer_list<T> items) : count_(items.size()) {
    std::copy(items.begin(), items.end(), items_.begin());
  }
  constexpr operator std::span<const T>() const { return {items_.data(), count_}; }

 private:
  std::array<T, 16> items_{};
  std::size_t count_;
};

// The parameters that rows of terms and models share.
namespace parameters {

inline constexpr Parameter diffuse_color{"cd", "diffuse colour", "", 0, 1, 0.5, Role::diffuse, true};
inline constexpr Parameter specular_color{"cs", "specular colour", "", 0, 1, 0.04, Role::f0, true};
inline constexpr Parameter f0{"f0", "reflectance at normal incidence", "", 0, 1, 0.04, Role::f0, true};
inline constexpr Parameter K{
    "K", "specular colour: reflectance at normal incidence", "", 0, 1, 0.04, Role::f0, true};
inline constexpr Parameter n{"n", "index of refraction, relative to the outside", "", 1e-3, 1e4, 1.5, Role::n,
                             true};
inline constexpr Parameter k{"k", "extinction", "", 0, 1e6, 0, Role::k, true};
inline constexpr Parameter g{"g",  "gloss; the lobe's exponent is 2^(12 g)", "", 0, 1, 0.75, Role::gloss,
                             false};
inline constexpr Parameter e{"e", "exponent of the lobe", "", 0, 1e6, 512, Role::exponent, false};
inline constexpr Parameter m_exponent{"m", "exponent of the lobe", "", 1, 1e6, 512, Role::exponent, false};
inline constexpr Parameter alpha{"alpha", "width of the lobe", "", 1e-4, 1, 0.1, Role::alpha, false};
inline constexpr Parameter m_slope{"m", "rms slope of the facets", "", 1e-4, 10, 0.1, Role::alpha, false};

// The colours of a curve of F, each with a name of its own.
constexpr Parameter curve(std::string_view name) {
  return {name, "colour of the curve of F", "", 0, 1, 0.5, Role::curve, true};
}

}  // namespace parameters
}  // namespace etak
