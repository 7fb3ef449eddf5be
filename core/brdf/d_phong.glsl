// SPDX-License-Identifier: Apache-2.0
// Blinn 1977 / Phong lobe as a microfacet distribution, (e + 2) / (2 pi) nm^e: integral of D nm is 1
// (Hoffman); and Schueler's (1 + e) / 2 nm^e, printed pi-scaled and unnormalised: D / pi integrates to (1
// + e) / (2 + e).
//   e    exponent, >= 0
//   s2   1 - nm^2
real d_phong_s2(real e, real nm, real s2) {
  real value = (e + 2) / (2 * pi) * power_of_cosine(e, nm, s2);
  return nm > 0 ? value : real(0);
}

real d_phong(real e, real nm) {
  return d_phong_s2(e, nm, (1 - nm) * (1 + nm));
}

real d_schueler_s2(real e, real nm, real s2) {
  real value = (1 + e) / 2 * power_of_cosine(e, nm, s2);
  return nm > 0 ? value : real(0);
}

real d_schueler_over_pi_s2(real e, real nm, real s2) {
  return d_schueler_s2(e, nm, s2) * (1 / pi);
}

real d_schueler(real e, real nm) {
  return d_schueler_s2(e, nm, (1 - nm) * (1 + nm));
}
