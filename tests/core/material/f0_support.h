// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/material/f0.h"
#include "tests/support.h"

/// Shorthands of the F0 tests.
namespace etak::test {

inline const std::vector<double> everywhere = wavelengths(350, 840, 10);

inline F0Options with_method(Method method) {
  F0Options options;
  options.method = method;
  return options;
}

inline F0Options extrapolating() {
  F0Options options;
  options.allow_extrapolation = true;
  return options;
}

inline F0Result solve(const Optics& optics, const F0Options& options = {}) {
  return F0Solver(options).solve(optics);
}

inline Optics flat(double r) {
  return reflectance(everywhere, [r](double) { return r; });
}

inline double worst_channel(const LinearRgb& a, const LinearRgb& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

inline double gold_n(double nm) {
  return 0.15 + 1.3 / (1 + std::exp((nm - 500) / 15));
}
inline double gold_k(double nm) {
  return 1.9 + 0.008 * std::max(0.0, nm - 490);
}

}  // namespace etak::test
