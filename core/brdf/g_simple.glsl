// SPDX-License-Identifier: Apache-2.0
// Two ways to leave geometry out, as G / (4 nl nv):
//   Kelemen and Szirmay-Kalos 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model": G / (nl nv) ~ 1 / lh^2
//   implicit (Hoffman): G = nl nv
real v_kelemen(Angles a) {
  return 1 / (4 * max(a.lh * a.lh, tiny));
}

real v_implicit(Angles a) {
  return real(0.25);
}
