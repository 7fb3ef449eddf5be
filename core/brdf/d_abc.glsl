// SPDX-License-Identifier: Apache-2.0
// ABC distribution of Hoffman's talk (after Church et al. 1989 and Low et al. 2012): norm (1 + a1 (1 -
// nm))^-a2. Printed with norm = 1; abc_norm() of normalise.h gives the one that makes the integral of D nm
// one.
//   a1   width, > 0
//   a2   fall-off, > 0
real d_abc_s2(real a1, real a2, real norm, real nm, real s2) {
  // 1 - nm = s2 / (1 + nm), without the cancellation.
  real value = norm * pow(1 + a1 * (s2 / (1 + nm)), -a2);
  return nm > 0 ? value : real(0);
}

real d_abc_printed_s2(real a1, real a2, real nm, real s2) {
  return d_abc_s2(a1, a2, real(1), nm, s2);
}

real d_abc(real a1, real a2, real norm, real nm) {
  return d_abc_s2(a1, a2, norm, nm, (1 - nm) * (1 + nm));
}
