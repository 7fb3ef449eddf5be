// SPDX-License-Identifier: Apache-2.0
// Trowbridge and Reitz 1975, "Average irregularity representation of a rough surface"; Walter et al. 2007,
// equation 33 (GGX): alpha^2 / (pi (nm^2 (alpha^2 - 1) + 1)^2), with the bracket as (1 - nm)(1 + nm) +
// nm^2 alpha^2, which float carries to alpha = 1e-4 and below. Integral of D nm over the hemisphere: 1. In
// 1/sr.
//   alpha   width, (0, 1]
real d_ggx_s2(real alpha, real nm, real s2) {
  real t = s2 / alpha + nm * nm * alpha;
  real value = 1 / (pi * t * t);
  return nm > 0 ? value : real(0);
}

real d_ggx(real alpha, real nm) {
  return d_ggx_s2(alpha, nm, (1 - nm) * (1 + nm));
}
