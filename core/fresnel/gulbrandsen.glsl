// SPDX-License-Identifier: Apache-2.0
// Gulbrandsen 2014, "Artist Friendly Metallic Fresnel", equations 2-5: n and k from reflectance r and edge
// tint g, and back; then the exact equations. Needs conductor.glsl.
//   r   reflectance at normal incidence, [0, 1): taken as at most 1 - 1e-6 in float, 1 - 1e-12 in double
//   g   edge tint, [0, 1]
real gulbrandsen_n(real r, real g) {
  real rr = clamp(r, real(0), largest_reflectance);
  real root = sqrt(rr);
  return mix((1 + root) * (1 + root) / (1 - rr), (1 - rr) / (1 + rr), g);
}

// k^2 = (r (n + 1)^2 - (n - 1)^2) / (1 - r) = (most - n)(n - 1 / most), both factors written as sums of positive terms:
// the plain form cancels for g near 0 and for r near 1.
real gulbrandsen_k(real r, real g) {
  real rr = clamp(r, real(0), largest_reflectance);
  real root = sqrt(rr);
  real square = (1 + root) * (1 + root);
  real span = 2 * root * square / ((1 - rr) * (1 + rr));
  real above = g * ((1 - rr) * 2 * root / ((1 + rr) * square)) + (1 - g) * (4 * root / (1 - rr));
  return sqrt(g * span * above);
}

real gulbrandsen_r(real n, real k) {
  return f0(n, k);
}

// g = (most - n) / (most - least), both differences times 1 - r: for r = 1 (n = 0) `most` itself has no value, and the
// edge tint is 1.
real gulbrandsen_g(real n, real k) {
  real r = f0(n, k);
  real rest = absorptance0(n, k);
  real root = sqrt(r);
  real square = (1 + root) * (1 + root);
  real span = square - rest * rest / (1 + r);
  return span > 0 ? clamp((square - n * rest) / span, real(0), real(1)) : real(0);
}

real f_gulbrandsen(real r, real g, real c) {
  return fresnel_exact(gulbrandsen_n(r, g), gulbrandsen_k(r, g), clamp(c, real(0), real(1)));
}

vec3 gulbrandsen_n(vec3 r, vec3 g) {
  return vec3(gulbrandsen_n(r.x, g.x), gulbrandsen_n(r.y, g.y), gulbrandsen_n(r.z, g.z));
}

vec3 gulbrandsen_k(vec3 r, vec3 g) {
  return vec3(gulbrandsen_k(r.x, g.x), gulbrandsen_k(r.y, g.y), gulbrandsen_k(r.z, g.z));
}

vec3 f_gulbrandsen(vec3 r, vec3 g, real c) {
  return fresnel_exact(gulbrandsen_n(r, g), gulbrandsen_k(r, g), clamp(c, real(0), real(1)));
}
