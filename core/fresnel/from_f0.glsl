// SPDX-License-Identifier: Apache-2.0
// Exact for dielectrics: k = 0 and n = (1 + sqrt F0) / (1 - sqrt F0).
//   f0   reflectance at normal incidence, [0, 1): taken as at most largest_reflectance
// n^2 - 1 of that n, without the cancellation of small F0.
real excess_from_f0(real f0_value) {
  real root = sqrt(clamp(f0_value, real(0), largest_reflectance));
  real rest = 1 - root;
  return 4 * root / (rest * rest);
}

vec3 excess_from_f0(vec3 f0_value) {
  return vec3(excess_from_f0(f0_value.x), excess_from_f0(f0_value.y), excess_from_f0(f0_value.z));
}

// Fresnel's equations for k = 0 and n >= 1 with one root, g = sqrt(n^2 - 1 + c^2), as Cook and Torrance 1981 have
// them; g - c is formed as (n^2 - 1) / (g + c).
//   excess   n^2 - 1, >= 0
//   c        cosine of incidence, [0, 1]
real fresnel_clear(real excess, real c) {
  real sum = sqrt(excess + c * c) + c;
  real difference = excess / max(sum, tiny);
  real rs = difference / max(sum, tiny);
  real rp = (c * sum - 1) / (c * difference + 1);
  return rs * rs * (1 + rp * rp) / 2;
}

vec3 fresnel_clear(vec3 excess, real c) {
  return vec3(fresnel_clear(excess.x, c), fresnel_clear(excess.y, c), fresnel_clear(excess.z, c));
}

real f_from_f0(real f0_value, real c) {
  return fresnel_clear(excess_from_f0(f0_value), clamp(c, real(0), real(1)));
}

vec3 f_from_f0(vec3 f0_value, real c) {
  return fresnel_clear(excess_from_f0(f0_value), clamp(c, real(0), real(1)));
}
