// SPDX-License-Identifier: Apache-2.0
#include "core/brdf/integrals/normalise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"
#include "core/math/quadrature.h"

namespace etak {
namespace {

using std::numbers::pi;

// (e^x - 1) / x, the mean of e^t for t from 0 to x.
double mean_exponential(double x) {
  return x == 0 ? 1 : math::expm1(x) / x;
}

}  // namespace

// With u = log(1 + a1) the integral is ((1 + a1) E(1 - a2) - E(2 - a2)) / a1^2, where
// E(z) = (e^(z u) - 1) / z; this form has no pole at a2 = 1 or 2. The two parts cancel for small a1, where the
// binomial series converges fast.
double abc_norm(double a1, double a2) {
  double integral;
  if (a1 * std::max(a2, 1.0) < 0.1) {
    integral = 0;
    double term = 1;  // C(-a2, j) a1^j
    for (int j = 0; j < 40; ++j) {
      integral += term / ((j + 1) * (j + 2));
      term *= -(a2 + j) / (j + 1) * a1;
    }
  } else {
    const double u = math::log1p(a1);
    integral = u * ((1 + a1) * mean_exponential((1 - a2) * u) - mean_exponential((2 - a2) * u)) / (a1 * a1);
  }
  return 1 / (2 * pi * integral);
}

// Gamma(1 - p, alpha) is the integral of y^-p e^-y from alpha to infinity. With y = alpha e^w it is
// alpha^(1-p) e^-alpha times the integral of exp((1 - p) w - alpha (e^w - 1)) from 0. The logarithm of that
// integrand is concave: it has one peak, and then falls faster than exponentially.
double log_sgd_norm(double alpha, double p) {
  const auto exponent = [&](double w) { return (1 - p) * w - alpha * math::expm1(w); };
  const double peak = p < 1 ? std::max(0.0, math::log((1 - p) / alpha)) : 0;
  const double most = exponent(peak);
  // The place behind `from` where the integrand has fallen to e^-45 of its peak.
  const auto drop = [&](double from, double step) {
    double w = step;
    while (exponent(from + w) > most - 45) w *= 2;
    double low = w / 2;
    for (int i = 0; i < 30; ++i) (exponent(from + (low + w) / 2) > most - 45 ? low : w) = (low + w) / 2;
    return from + w;
  };
  const double end = drop(peak, 1e-3 / (1 + alpha + std::abs(p)));
  constexpr int panels = 256;
  double sum = 0;
  for (int i = 0; i < panels; ++i)
    sum += gauss_legendre<16>([&](double w) { return math::exp(exponent(w) - most); }, end * i / panels,
                              end * (i + 1) / panels);
  return -(math::log(sum) + most + (1 - p) * math::log(alpha) - alpha);
}

}  // namespace etak
