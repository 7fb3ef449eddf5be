// SPDX-License-Identifier: Apache-2.0
// Shifted gamma distribution, Bagher, Soler and Holzschuch 2012, "Accurate fitting of measured
// reflectances using a Shifted Gamma micro-facet distribution": p22(tan^2) / (pi nm^4), p22(x) =
// alpha^(p-1) exp(-(alpha^2 + x)/alpha) / (Gamma(1 - p, alpha) (alpha^2 + x)^p). Integral of D nm: 1.
//   alpha, p   > 0
//   log_norm   -ln Gamma(1 - p, alpha), which no GPU has: log_sgd_norm() of normalise.h
real d_sgd_s2(real alpha, real p, real log_norm, real nm, real s2) {
  real c2 = max(nm * nm, real(1e-12));
  real x = alpha * alpha + s2 / c2;
  // One exponent for all factors: they leave float's range one by one, not together.
  real power = log_norm + (p - 1) * log(alpha) - p * log(x) - x / alpha;
  real value = exp(max(power, exponent_floor)) / (pi * c2 * c2);
  return nm > 0 ? value : real(0);
}

real d_sgd(real alpha, real p, real log_norm, real nm) {
  return d_sgd_s2(alpha, p, log_norm, nm, (1 - nm) * (1 + nm));
}
