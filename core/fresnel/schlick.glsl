// SPDX-License-Identifier: Apache-2.0
// Schlick 1994, "An Inexpensive BRDF Model for Physically-Based Rendering", equation 15:
// F = F0 + (1 - F0) (1 - c)^5. F0 above 1 (gold red) falls to 1 at grazing.
//   f0   reflectance at normal incidence; out-of-gamut values below 0 are taken as they are
//   c    cosine of incidence; clamped to [0, 1], since 1 - c a little below 0 has an odd power
real schlick_rise(real c) {
  real m = 1 - clamp(c, real(0), real(1));
  real m2 = m * m;
  return m2 * m2 * m;
}

// What the rise leaves, 1 - (1 - c)^5, without the cancellation at grazing: 1 - F = (1 - F0) times this.
real schlick_rest(real c) {
  real cc = clamp(c, real(0), real(1));
  real m = 1 - cc;
  return cc * (1 + m * (1 + m * (1 + m * (1 + m))));
}

real f_schlick(real f0, real c) {
  return f0 + (1 - f0) * schlick_rise(c);
}

vec3 f_schlick(vec3 f0, real c) {
  return f0 + (vec3(1) - f0) * schlick_rise(c);
}
