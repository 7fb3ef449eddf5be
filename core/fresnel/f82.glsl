// SPDX-License-Identifier: Apache-2.0
// Schlick bent so that it also passes through the reflectance at cos = 1/7. For metals only: on
// dielectrics it loses Brewster's dip. Needs schlick.glsl.
//   Hoffman 2019, "Fresnel Equations Considered Harmful": F = Schlick - a c (1 - c)^6
//   Kutz et al. 2021, "Novel aspects of the Adobe Standard Material" (OpenPBR): F82 = tint * Schlick(1/7)
const real f82_cosine = real(1) / 7;

//   f0, f82   reflectance at cos = 1 and cos = 1/7
//   c         cosine, clamped to [0, 1]
real f_f82(real f0, real f82, real c) {
  real cc = clamp(c, real(0), real(1));
  real m = 1 - cc;
  real m3 = m * m * m;
  real a = (f_schlick(f0, f82_cosine) - f82) / (f82_cosine * (real(46656) / 117649));
  return f_schlick(f0, c) - a * cc * (m3 * m3);
}

vec3 f_f82(vec3 f0, vec3 f82, real c) {
  return vec3(f_f82(f0.x, f82.x, c), f_f82(f0.y, f82.y, c), f_f82(f0.z, f82.z, c));
}

// The mean over a diffuse hemisphere, the integral of 2 c F(c), which the energy between facets is computed by
// (compensated.glsl takes it by a sum that is exact for this form too). OpenPBR 1.1.1 states it.
real f82_mean(real f0, real f82) {
  real a = (f_schlick(f0, f82_cosine) - f82) / (f82_cosine * (real(46656) / 117649));
  return f0 + (1 - f0) / 21 - a / 126;
}

//   tint   in [0, 1]
real f_f82_tint(real f0, real tint, real c) {
  return f_f82(f0, tint * f_schlick(f0, f82_cosine), c);
}

vec3 f_f82_tint(vec3 f0, vec3 tint, real c) {
  return vec3(f_f82_tint(f0.x, tint.x, c), f_f82_tint(f0.y, tint.y, c), f_f82_tint(f0.z, tint.z, c));
}
