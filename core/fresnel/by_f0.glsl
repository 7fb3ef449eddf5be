// SPDX-License-Identifier: Apache-2.0
// F where F0 is all that is known, as in textures, per channel: a dielectric's below the forbidden zone (k =
// 0, exact), Schlick's form from there on, because F0 says no more of a metal.
//   f0   reflectance at normal incidence
//   c    cosine of incidence, [0, 1]
const real least_metal_f0 = real(0.2);

real f_by_f0(real f0_value, real c) {
  return f0_value < least_metal_f0 ? f_from_f0(f0_value, c) : f_schlick(f0_value, c);
}

vec3 f_by_f0(vec3 f0_value, real c) {
  return vec3(f_by_f0(f0_value.x, c), f_by_f0(f0_value.y, c), f_by_f0(f0_value.z, c));
}
