// SPDX-License-Identifier: Apache-2.0
// Oren and Nayar 1994, "Generalization of Lambert's Reflectance Model", the qualitative model (equation
// 30), in vector form: s = l.v - nl nv is cos(phi) sin sin, defined at the poles too. Albedo reaches
// 1.0152 (sigma 0.1985, grazing).
//   rho     albedo, [0, 1]
//   sigma   standard deviation of the facets' slope angle, radians, [0, pi/2]
vec3 brdf_oren_nayar(Angles a, vec3 rho, real sigma) {
  real s2 = sigma * sigma;
  real A = 1 - real(0.5) * s2 / (s2 + real(0.33));
  real B = real(0.45) * s2 / (s2 + real(0.09));
  real s = a.lv - a.nl * a.nv;
  real most = max(a.nl, a.nv);
  return rho * ((A + B * max(s, real(0)) / most) * (1 / pi));
}
