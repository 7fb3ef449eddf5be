// SPDX-License-Identifier: Apache-2.0
// Discrete lights. What arrives is E, the irradiance on a plane that faces the light (W/m^2, or lux).

// Point light of intensity I (W/sr) at distance r > 0: I / r^2.
vec3 point_irradiance(vec3 I, real r) {
  return I * (1 / (r * r));
}

// Share of a spot light's beam at cosine c from its axis: 1 inside the inner cone, 0 outside the outer
// one, smoothstep in the cosine between (etak's choice; the lecture prints none), a step where both are
// one.
//   cos_inner >= cos_outer
real spot_share(real c, real cos_inner, real cos_outer) {
  real span = cos_inner - cos_outer;
  real t = span > 0 ? clamp((c - cos_outer) / span, real(0), real(1)) : (c >= cos_inner ? real(1) : real(0));
  return t * t * (3 - 2 * t);
}
