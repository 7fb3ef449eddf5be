// SPDX-License-Identifier: Apache-2.0
// Beckmann and Spizzichino 1963 as in Cook and Torrance 1981: exp(-tan^2 / m^2) / (pi m^2 nm^4), whose
// integral of D nm is 1; and as printed in the lecture, 1 / (4 m^2 nm^4) in place of 1 / (pi m^2 nm^4),
// whose integral is pi / 4.
//   m   rms slope, > 0
real d_beckmann_s2(real m, real nm, real s2) {
  real c2 = max(nm * nm, real(1e-12));
  real steep = 1 / (c2 * m * m);
  real value = exp(max(-s2 * steep, exponent_floor)) * ((steep * m) * (steep * m) * (1 / pi));
  return nm > 0 ? value : real(0);
}

real d_beckmann(real m, real nm) {
  return d_beckmann_s2(m, nm, (1 - nm) * (1 + nm));
}

real d_beckmann_printed_s2(real m, real nm, real s2) {
  return d_beckmann_s2(m, nm, s2) * (pi / 4);
}

real d_beckmann_printed(real m, real nm) {
  return d_beckmann(m, nm) * (pi / 4);
}
