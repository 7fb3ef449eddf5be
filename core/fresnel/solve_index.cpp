// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel/solve_index.h"

#include <algorithm>
#include <cmath>

#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

// The F0 of a colour may be above 1 (gold in sRGB), but no n and k reflect more than 1.
constexpr double largest_f0 = 0.9999;
constexpr double smallest_f0 = 0;
// The k that gives reflectance r at normal incidence together with n.
double k_of(double r, double n) {
  return std::sqrt(std::max(0.0, (r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r)));
}

}  // namespace

// By bisection in log n. F82 falls and rises again along the possible n, so there are up to two solutions,
// and sometimes none: then the n that misses least.
SolvedIndex solve_index(double f0, double f82, double log_n_hint) {
  // Where F0 is above 1, the nearest F0 of a metal with this edge is a little below the F82.
  const double r = f0 < largest_f0 ? std::max(f0, smallest_f0) : std::clamp(f82, 0.5, largest_f0);
  const double root = std::sqrt(r);
  const double least = std::log((1 - r) / (1 + r)), most = std::log((1 + root) / (1 - root));
  const auto missed = [&](double log_n) {
    const double n = std::exp(log_n);
    return f64::fresnel_exact(n, k_of(r, n), f82_cosine) - f82;
  };
  constexpr int steps = 256;
  const auto node = [&](int i) { return least + (most - least) * i / steps; };
  double best = least, best_miss = std::abs(missed(least));
  bool best_is_root = false;
  // A root beats any other n; of two roots the one nearer to the hint, of two others the one that misses
  // less.
  const auto offer = [&](double log_n, bool is_root) {
    const double miss = std::abs(missed(log_n));
    const bool nearer = std::abs(log_n - log_n_hint) < std::abs(best - log_n_hint);
    if (is_root ? !best_is_root || nearer : !best_is_root && miss < best_miss) {
      best = log_n;
      best_miss = miss;
      best_is_root = is_root;
    }
  };
  double before = missed(node(0));
  for (int i = 1; i <= steps; ++i) {
    const double after = missed(node(i));
    offer(node(i), after == 0);
    if (before * after < 0) {
      double low = node(i - 1), high = node(i);
      for (int step = 0; step < 60; ++step) {
        const double middle = (low + high) / 2;
        (missed(middle) * before > 0 ? low : high) = middle;
      }
      offer((low + high) / 2, true);
    }
    before = after;
  }
  if (!best_is_root) {
    // The least miss lies within a step of the best node.
    double low = std::max(least, best - (most - least) / steps),
           high = std::min(most, best + (most - least) / steps);
    for (int step = 0; step < 60; ++step) {
      const double third = (high - low) / 3;
      if (std::abs(missed(low + third)) < std::abs(missed(high - third)))
        high -= third;
      else
        low += third;
    }
    offer((low + high) / 2, false);
  }
  const double n = std::exp(best);
  return {n, k_of(r, n)};
}

}  // namespace etak
