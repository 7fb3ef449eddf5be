// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/math/functions.h"

namespace etak {

/// Nodes and weights of Gauss-Legendre quadrature over [-1, 1], by Newton's method on the Legendre
/// polynomial.
template <std::size_t N>
struct GaussLegendre {
  std::array<double, N> node, weight;

  GaussLegendre() {
    for (std::size_t i = 0; i < N; ++i) {
      double x = math::cos(3.14159265358979323846 * (static_cast<double>(i) + 0.75) / (N + 0.5)), slope = 1;
      for (int round = 0; round < 8; ++round) {
        double before = 1, here = x;
        for (std::size_t k = 2; k <= N; ++k) {
          const double d = static_cast<double>(k);
          const double next = ((2 * d - 1) * x * here - (d - 1) * before) / d;
          before = here;
          here = next;
        }
        slope = N * (before - x * here) / (1 - x * x);
        x -= here / slope;
      }
      node[i] = x;
      weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

/// Integral of f over [a, b] in one piece; exact for polynomials of degree 2 N - 1.
template <std::size_t N, class F>
double gauss_legendre(const F& f, double a, double b) {
  static const GaussLegendre<N> rule;
  const double middle = (a + b) / 2, half = (b - a) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += rule.weight[i] * f(middle + half * rule.node[i]);
  return sum * half;
}

/// Integral of f over [a, b], halving until two halves of 10 points agree with the whole within `error`
/// (absolute), at most `depth` times. Kinks are found by halving; jumps should lie at a or b.
template <class F>
double adaptive_integral(const F& f, double a, double b, double error, int depth = 24) {
  struct Panel {
    double a, b, value, error;
    int depth;
  };
  double sum = 0;
  std::vector<Panel> open{{a, b, gauss_legendre<10>(f, a, b), error, depth}};
  while (!open.empty()) {
    const Panel p = open.back();
    open.pop_back();
    const double middle = (p.a + p.b) / 2;
    const double left = gauss_legendre<10>(f, p.a, middle), right = gauss_legendre<10>(f, middle, p.b);
    if (p.depth == 0 || std::abs(left + right - p.value) <= p.error) {
      sum += left + right;
    } else {
      open.push_back({p.a, middle, left, p.error / 2, p.depth - 1});
      open.push_back({middle, p.b, right, p.error / 2, p.depth - 1});
    }
  }
  return sum;
}

}  // namespace etak
