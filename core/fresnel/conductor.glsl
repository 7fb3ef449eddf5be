// SPDX-License-Identifier: Apache-2.0
// Fresnel reflectance of a smooth interface to a medium with complex index, unpolarised light.
// Based on:
//   Cook and Torrance 1981, "A Reflectance Model for Computer Graphics": the complex equations
// n, k: index and extinction relative to the outside medium, 0 <= n <= 1e4, 0 <= k <= 1e6. n = 0 with k > 0 is a metal
// without loss and reflects everything; so does, in the limit, n = k = 0, which is no medium.

// Reflectance at normal incidence. n - 1 is formed before it is squared: n*n - 2*n + 1 is 32 % off in
// float for n = 1.0003.
real f0(real n, real k) {
  return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

// 1 - F0 without cancellation, for k far above 1.
real absorptance0(real n, real k) {
  return 4 * n / ((n + 1) * (n + 1) + k * k);
}

// Reflectance at cosine of incidence c in [0, 1]: the a^2 + b^2 form rearranged so that nothing cancels.
// Worst relative error 5e-15 in double and 2e-6 in float for n in [0.01, 20], k in [0, 100] and n near 1,
// where the usual form loses every digit in float; but for the neighbourhood of the critical angle (n < 1,
// k near 0, |eta^2 - s2| < 0.03 c^2), where the last digit of c itself weighs so much: there 2e-12 and
// 5e-4. n = 1, k = 0 gives 0 at every angle; otherwise c = 0 gives 1. Divisors are kept above `tiny`: a
// test would keep loops from being vectorised. No square leaves the range of float for n <= 1e4, k <= 1e6.
// Below `least_index` the reflectance is 1 but for 4 n, which double cannot show beside 1, and n^2 would leave the
// range of float. Below `small_index` n^2 would be lost beside the 1 of n^2 - 1, so nothing is compared with 1 there.
const real least_index = real(1e-17);
const real small_index = real(0.01);

real fresnel_exact(real n_asked, real k, real c) {
  real n = max(n_asked, least_index);
  real s2 = (1 - c) * (1 + c);
  real q = (n - 1) * (n + 1);
  real k2 = k * k;
  // (a + i b)^2 = eta^2 - s2 = x + i y
  real x_below = q + (c - k) * (c + k);
  real x_above = q + c * c - k2;
  real x_small = (n - k) * (n + k) - s2;
  real x_least = n < small_index ? x_small : x_below;
  real x = q < 0 ? x_least : x_above;
  real y = 2 * n * k;
  real big = sqrt((sqrt(x * x + y * y) + abs(x)) / 2);
  real small = y / (2 * max(big, tiny));
  real a = x < 0 ? small : big;
  real b = x < 0 ? big : small;
  // a - c: for x >= 0, where a is `big`, from (a^2 - c^2) / (a + c) = (q + k^2 s2 / (a^2 + k^2)) / (a + c), without
  // subtracting near equals.
  real ak = big * big + k2;
  real d_above = (q * ak + k2 * s2) / max(ak * (big + c), tiny);
  real d = x < 0 ? a - c : d_above;
  // R_s = rs / under, R_p = R_s near / far with near, far = (a c -+ s2)^2 + b^2 c^2; their mean is `mean`.
  real b2 = b * b;
  real rs = d * d + b2;
  real under = (a + c) * (a + c) + b2;
  real ac = a * c;
  real mean = ac * ac + s2 * s2 + b2 * (c * c);
  real far = mean + 2 * ac * s2;
  return rs * mean / max(under * far, tiny);
}

vec3 fresnel_exact(vec3 n, vec3 k, real c) {
  return vec3(fresnel_exact(n.x, k.x, c), fresnel_exact(n.y, k.y, c), fresnel_exact(n.z, k.z, c));
}
