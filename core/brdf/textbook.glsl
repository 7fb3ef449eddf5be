// SPDX-License-Identifier: Apache-2.0
// Formulas as textbooks and most renderers have them, where that loses digits, overflows or divides by zero: no model
// uses them. `etak stability` shows what they give beside etak's own.

// Conductor Fresnel in the a^2 + b^2 form (Cook and Torrance 1981, as usually coded).
real naive_conductor(real n, real k, real c) {
  real c2 = c * c;
  real s2 = 1 - c2;
  real t0 = n * n - k * k - s2;
  real a2b2 = sqrt(t0 * t0 + 4 * n * n * k * k);
  real t1 = a2b2 + c2;
  real a = sqrt((a2b2 + t0) / 2);
  real t2 = 2 * a * c;
  real rs = (t1 - t2) / (t1 + t2);
  real t3 = c2 * a2b2 + s2 * s2;
  real t4 = t2 * s2;
  real rp = rs * (t3 - t4) / (t3 + t4);
  return (rs + rp) / 2;
}

real naive_f0(real n, real k) {
  return (n * n - 2 * n + 1 + k * k) / (n * n + 2 * n + 1 + k * k);
}

real naive_from_f0(real f0_value, real c) {
  real root = sqrt(f0_value);
  return naive_conductor((1 + root) / (1 - root), real(0), c);
}

// F0 under a coat of index n, the medium taken as a dielectric.
real naive_under(real f0_value, real n) {
  real root = sqrt(f0_value);
  real index = (1 + root) / (1 - root);
  return (index - n) / (index + n) * ((index - n) / (index + n));
}

// 5th power of 1 - c without a clamp.
real naive_schlick(real f0_value, real c) {
  real m = 1 - c;
  return f0_value + (1 - f0_value) * (m * m * m * m * m);
}

real naive_f_schueler(real K, real t) {
  real m = 1 - t;
  return mix(K, min(60 * K, real(1)), m * m * m * m);
}

real naive_nh(vec3 l, vec3 v) {
  vec3 s = l + v;
  return s.z / sqrt(dot(s, s));
}

real naive_ggx(real alpha, real nm) {
  real a2 = alpha * alpha;
  real t = nm * nm * (a2 - 1) + 1;
  return a2 / (pi * t * t);
}

real naive_beckmann(real m, real nm) {
  real tan2 = (1 - nm * nm) / (nm * nm);
  return exp(-tan2 / (m * m)) / (pi * m * m * (nm * nm) * (nm * nm));
}

real naive_g1_ggx(real c, real alpha) {
  real tan2 = (1 - c * c) / (c * c);
  return 2 / (1 + sqrt(1 + alpha * alpha * tan2));
}

// (nu hu^2 + nv hv^2) / (1 - nh^2) at the half vector that is the normal.
real naive_ashikhmin_exponent(real nu, real nv, real nh) {
  return (nu * real(0) + nv * real(0)) / (1 - nh * nh);
}

// Cosine of the azimuth between light and viewer from their polar cosines.
real naive_cos_phi(real lv, real nl, real nv) {
  return (lv - nl * nv) / (sqrt(1 - nl * nl) * sqrt(1 - nv * nv));
}

// The cosines of two directions, as given.
Angles plain_angles(real nl, real nv, real nh, real lh, real s2) {
  Angles a;
  a.nl = nl;
  a.nv = nv;
  a.nh = nh;
  a.lh = lh;
  a.lv = 2 * lh * lh - 1;
  a.s2 = s2;
  a.hu2 = s2;
  a.hv2 = real(0);
  a.valid = min(nl, nv);
  return a;
}
