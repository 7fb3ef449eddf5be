// SPDX-License-Identifier: Apache-2.0
// Phong 1975 as printed in the lecture: L = (cd nl + cs max(v.r, 0)^m) B, here divided by pi nl. The
// specular part is gated by nl > 0, which the lecture's shader forgot. No BRDF: not reciprocal, unbounded
// as nl tends to 0.
//   cd, cs   diffuse and specular colour, [0, 1]
//   m        exponent, >= 1
vec3 brdf_phong(Angles a, vec3 cd, vec3 cs, real m) {
  // |r - v|^2 = 2 - 2 v.r without the cancellation: r - v is (-(l + v).x, -(l + v).y, l.z - v.z).
  real chord2 = 4 * a.s2 * a.lh * a.lh + (a.nl - a.nv) * (a.nl - a.nv);
  real vr = 1 - chord2 / 2;
  real power = power_of_cosine(m, vr, clamp(chord2 * (1 - chord2 / 4), real(0), real(1)));
  real lobe = vr > 0 ? power : real(0);
  return cd * (1 / pi) + brdf_microfacet(cs, lobe / a.nl, 1 / pi);
}
