// SPDX-License-Identifier: Apache-2.0
// Cook and Torrance 1981, Hoffman: f = D F G / (4 nl nv) with V = G / (4 nl nv). F is kept at or above 0,
// which colours out of gamut leave, and F82 and Lazanyi for a dip deeper than the curve.
vec3 brdf_microfacet(vec3 F, real D, real V) {
  return vec3(max(F.x, real(0)), max(F.y, real(0)), max(F.z, real(0))) * (D * V);
}
