// SPDX-License-Identifier: Apache-2.0
// log2 of c2 = 1 - s2, where s2 is known without cancellation (core/math/glsl.h has the same for C++). For
// small s2 from 1 - s2 with the rounding of that difference divided out (Kahan's log1p).
float log2_complement(float c2, float s2) {
  float u = 1.0 - s2;
  float lost = 1.0 - u;
  float near = lost > 0.0 ? log2(max(u, 0.25)) * (s2 / max(lost, tiny)) : -1.44269504 * s2;
  return s2 < 0.5 ? near : log2(max(c2, tiny));
}
