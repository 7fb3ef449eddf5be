// SPDX-License-Identifier: Apache-2.0
// Cook and Torrance 1981 as in the lecture: D F G / (4 nl nv) with Beckmann's D, exact F, V-groove G.
// Printed with the D of 1 / (4 m^2), which belongs to the 1981 form over pi: together with the 4
// everything is pi / 4 too dark.
//   n, k   complex index
//   m      rms slope, > 0
vec3 brdf_cook_torrance(Angles a, vec3 n, vec3 k, real m) {
  return fresnel_exact(n, k, a.lh) * (d_beckmann_s2(m, a.nh, a.s2) * v_cook_torrance(a));
}

vec3 brdf_cook_torrance_printed(Angles a, vec3 n, vec3 k, real m) {
  return brdf_cook_torrance(a, n, k, m) * (pi / 4);
}
