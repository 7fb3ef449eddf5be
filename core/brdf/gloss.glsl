// SPDX-License-Identifier: Apache-2.0
// Schueler 2009: gloss g in [0, 1] to the lobe's exponent e = 2^(12 g), 1 to 4096; and the Beckmann or GGX
// width of the same lobe, sqrt(2 / (e + 2)).
real gloss_exponent(real g) {
  return exp2(12 * g);
}

real exponent_alpha(real e) {
  return sqrt(2 / (e + 2));
}
