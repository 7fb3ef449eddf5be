// SPDX-License-Identifier: Apache-2.0
// Smith 1967 masking for GGX: Walter et al. 2007 (equation 34), Heitz 2014, "Understanding the
// Masking-Shadowing Function in Microfacet-Based BRDFs" (equation 99: height-correlated). No tangent is
// formed, so grazing is finite.
//   c       cosine with the normal, [0, 1]
//   alpha   width, (0, 1]
real smith_ggx_root(real c, real alpha) {
  return sqrt(alpha * alpha + (1 - alpha * alpha) * (c * c));
}

real g1_ggx(real c, real alpha) {
  return 2 * c / max(c + smith_ggx_root(c, alpha), tiny);
}

real g2_ggx_uncorrelated(real nl, real nv, real alpha) {
  return g1_ggx(nl, alpha) * g1_ggx(nv, alpha);
}

real g2_ggx_height(real nl, real nv, real alpha) {
  return 2 * nl * nv / max(nl * smith_ggx_root(nv, alpha) + nv * smith_ggx_root(nl, alpha), tiny);
}

real v_smith_ggx_uncorrelated(Angles a, real alpha) {
  return 1 / ((a.nl + smith_ggx_root(a.nl, alpha)) * (a.nv + smith_ggx_root(a.nv, alpha)));
}

real v_smith_ggx_height(Angles a, real alpha) {
  return real(0.5) / (a.nl * smith_ggx_root(a.nv, alpha) + a.nv * smith_ggx_root(a.nl, alpha));
}
