// SPDX-License-Identifier: Apache-2.0
// F as a curve: a cubic B-spline of 16 colours at even steps of the square root of the cosine, over which stacks of layers
// and metals change evenly. r1 lies at grazing incidence, r14 at normal, r0 and r15 a step beyond. Between the least and the
// greatest of the four colours around it, the curve never leaves what they leave open.

//   t   distance from the place of a colour, in steps
real curve_weight(real t) {
  real a = max(2 - abs(t), real(0));
  real b = max(1 - abs(t), real(0));
  return (a * a * a - 4 * (b * b * b)) / 6;
}

//   c   cosine, clamped to [0, 1]
vec3 f_curve(vec3 r0, vec3 r1, vec3 r2, vec3 r3, vec3 r4, vec3 r5, vec3 r6, vec3 r7, vec3 r8, vec3 r9, vec3 r10, vec3 r11,
             vec3 r12, vec3 r13, vec3 r14, vec3 r15, real c) {
  real x = 1 + 13 * sqrt(clamp(c, real(0), real(1)));
  vec3 grazing = r0 * curve_weight(x) + r1 * curve_weight(x - 1) + r2 * curve_weight(x - 2) + r3 * curve_weight(x - 3);
  vec3 steep = r4 * curve_weight(x - 4) + r5 * curve_weight(x - 5) + r6 * curve_weight(x - 6) + r7 * curve_weight(x - 7);
  vec3 middle = r8 * curve_weight(x - 8) + r9 * curve_weight(x - 9) + r10 * curve_weight(x - 10) + r11 * curve_weight(x - 11);
  vec3 normal = r12 * curve_weight(x - 12) + r13 * curve_weight(x - 13) + r14 * curve_weight(x - 14) + r15 * curve_weight(x - 15);
  return grazing + steep + middle + normal;
}
