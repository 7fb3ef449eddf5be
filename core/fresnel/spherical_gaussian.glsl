// SPDX-License-Identifier: Apache-2.0
// Lagarde 2012, "Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel": Schlick with its
// power replaced by 2^((-5.55473 c - 6.98316) c).
//   f0   reflectance at normal incidence
//   c    cosine, clamped to [0, 1]
real f_spherical_gaussian(real f0, real c) {
  real cc = clamp(c, real(0), real(1));
  return f0 + (1 - f0) * exp2((real(-5.55473) * cc - real(6.98316)) * cc);
}

vec3 f_spherical_gaussian(vec3 f0, real c) {
  real cc = clamp(c, real(0), real(1));
  return f0 + (vec3(1) - f0) * exp2((real(-5.55473) * cc - real(6.98316)) * cc);
}
