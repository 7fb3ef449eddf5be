// SPDX-License-Identifier: Apache-2.0
// Exact for dielectrics: k = 0 and n = (1 + sqrt F0) / (1 - sqrt F0). Needs conductor.glsl.
//   f0   reflectance at normal incidence, [0, 1): taken as at most largest_reflectance
real n_from_f0(real f0_value) {
  real root = sqrt(clamp(f0_value, real(0), largest_reflectance));
  return (1 + root) / (1 - root);
}

vec3 n_from_f0(vec3 f0_value) {
  return vec3(n_from_f0(f0_value.x), n_from_f0(f0_value.y), n_from_f0(f0_value.z));
}

real f_from_f0(real f0_value, real c) {
  return fresnel_exact(n_from_f0(f0_value), real(0), clamp(c, real(0), real(1)));
}

vec3 f_from_f0(vec3 f0_value, real c) {
  return fresnel_exact(n_from_f0(f0_value), vec3(0), clamp(c, real(0), real(1)));
}
