// SPDX-License-Identifier: Apache-2.0
// Schueler 2009, "An Efficient and Physically Plausible Real-Time Shading Model": F(t) = lerp(K, min(60 K,
// 1), (1 - t)^4). The full rise needs K >= 1/60; below, K is a mask that takes its own rim away.
//   K   specular colour; below 0 taken as 0 (60 K would give -0.6 for K = -0.01)
//   t   cosine, clamped to [0, 1]
real schueler_low(real K) {
  return max(K, real(0));
}

real schueler_high(real K) {
  return min(60 * max(K, real(0)), real(1));
}

real schueler_rise(real t) {
  real m = 1 - clamp(t, real(0), real(1));
  real m2 = m * m;
  return m2 * m2;
}

real f_schueler(real K, real t) {
  return mix(schueler_low(K), schueler_high(K), schueler_rise(t));
}

// The two ends for a colour: the same for a whole surface.
struct SchuelerEnds {
  vec3 low;
  vec3 high;
};

SchuelerEnds schueler_ends(vec3 K) {
  SchuelerEnds ends;
  ends.low = vec3(schueler_low(K.x), schueler_low(K.y), schueler_low(K.z));
  ends.high = vec3(schueler_high(K.x), schueler_high(K.y), schueler_high(K.z));
  return ends;
}

vec3 f_schueler(SchuelerEnds ends, real t) {
  return mix(ends.low, ends.high, schueler_rise(t));
}

vec3 f_schueler(vec3 K, real t) {
  return f_schueler(schueler_ends(K), t);
}
