// SPDX-License-Identifier: Apache-2.0
// Display transfer: the exact curve of IEC 61966-2-1, a power of 2.2, Schueler's two shortcuts, and none (HDR).
real srgb_encode(real x) {
  return x <= real(0.0031308) ? real(12.92) * x : real(1.055) * pow(x, real(1) / real(2.4)) - real(0.055);
}

real srgb_decode(real y) {
  return y <= real(0.04045) ? y / real(12.92) : pow((y + real(0.055)) / real(1.055), real(2.4));
}

real power22_encode(real x) {
  return pow(max(x, real(0)), real(1) / real(2.2));
}

// 2.2 in, 0.45 out, as printed: 0.99 together, not an inverse.
real power045_encode(real x) {
  return pow(max(x, real(0)), real(0.45));
}

real power22_decode(real y) {
  return pow(max(y, real(0)), real(2.2));
}

// 2.0: squaring in, square root out.
real root_encode(real x) {
  return sqrt(max(x, real(0)));
}

real square_decode(real y) {
  return y * y;
}
