// SPDX-License-Identifier: Apache-2.0
// Smith 1967 masking for the Beckmann distribution with the error function itself (Walter et al. 2007,
// equation 27 is the rational fit of it): G1 = 1 / (1 + Lambda), Lambda = (erf(a) - 1) / 2 + exp(-a^2) / (2 a
// sqrt(pi)), a = 1 / (m tan).
//   c   cosine with the normal, [0, 1]
//   m   rms slope, > 0

// c (1 + Lambda): with c / a = m sin nothing is divided by a cosine that may be 0.
real smith_beckmann_reach(real c, real m) {
  real ms = m * sqrt(max((1 - c) * (1 + c), real(0)));
  // Past a = 7 the exponential is below 1e-21.
  real a = min(c / max(ms, tiny), real(7));
  return (c * (1 + erf(a)) + ms * exp(-a * a) * real(0.56418958354775628695)) / 2;
}

real g1_beckmann_exact(real c, real m) {
  real value = c / max(smith_beckmann_reach(c, m), tiny);
  return c > 0 ? value : real(0);
}

// G / (4 nl nv): G1(nl) G1(nv), or 1 / (1 + Lambda(nl) + Lambda(nv)).
real v_smith_beckmann_uncorrelated(Angles a, real m) {
  return 1 / (4 * smith_beckmann_reach(a.nl, m) * smith_beckmann_reach(a.nv, m));
}

real v_smith_beckmann_height(Angles a, real m) {
  real light = smith_beckmann_reach(a.nl, m);
  real view = smith_beckmann_reach(a.nv, m);
  return 1 / (4 * (a.nv * light + a.nl * view - a.nl * a.nv));
}
