// SPDX-License-Identifier: Apache-2.0
// Error function: Abramowitz and Stegun 1964, formula 7.1.26; absolute error 1.5e-7.
float erf(float x) {
  float a = abs(x);
  float t = 1.0 / (1.0 + 0.3275911 * a);
  float p = ((((1.061405429 * t - 1.453152027) * t + 1.421413741) * t - 0.284496736) * t + 0.254829592) * t;
  float y = 1.0 - p * exp(-a * a);
  return x < 0.0 ? -y : y;
}
