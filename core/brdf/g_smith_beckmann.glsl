// SPDX-License-Identifier: Apache-2.0
// Smith 1967 masking for the Beckmann distribution with the error function itself (Walter et al. 2007,
// equation 27 is the rational fit of it): Lambda = (erf(a) - 1) / 2 + exp(-a^2) / (2 a sqrt(pi)), a = 1 /
// (m tan).
//   c   cosine with the normal, [0, 1];   m   rms slope, > 0
real smith_beckmann_lambda(real c, real m) {
  real s = sqrt(max((1 - c) * (1 + c), real(0)));
  // Past a = 7 both parts are below 1e-22. The lower bound keeps nl = 0 finite.
  real a = clamp(c / max(m * s, tiny), real(1e-18), real(7));
  return (erf(a) - 1) / 2 + exp(-a * a) / (2 * a * real(1.77245385090551602730));
}

real g1_beckmann_exact(real c, real m) {
  real value = 1 / (1 + smith_beckmann_lambda(c, m));
  return c > 0 ? value : real(0);
}

real v_smith_beckmann_uncorrelated(Angles a, real m) {
  return g1_beckmann_exact(a.nl, m) * g1_beckmann_exact(a.nv, m) / (4 * a.nl * a.nv);
}

real v_smith_beckmann_height(Angles a, real m) {
  return 1 / (4 * a.nl * a.nv * (1 + smith_beckmann_lambda(a.nl, m) + smith_beckmann_lambda(a.nv, m)));
}
