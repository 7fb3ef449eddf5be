// SPDX-License-Identifier: Apache-2.0
// Blinn 1977 as in the lecture: cd / pi + (m + 8) / (8 pi) cs nh^m, an approximate normalisation (albedo
// 1.075 at m = 8.8, normal incidence); and with the exact one, (m + 2)(m + 4) / (8 pi (2^(-m/2) + m))
// (Giesen 2009).
//   cd, cs   diffuse and specular colour, [0, 1]
//   m        exponent, >= 1
vec3 blinn_phong(Angles a, vec3 cd, vec3 cs, real m, real scale) {
  return cd * (1 / pi) + brdf_microfacet(cs, power_of_cosine(m, a.nh, a.s2), scale);
}

vec3 brdf_blinn_phong(Angles a, vec3 cd, vec3 cs, real m) {
  return blinn_phong(a, cd, cs, m, (m + 8) / (8 * pi));
}

real blinn_phong_exact_scale(real m) {
  return (m + 2) * (m + 4) / (8 * pi * (exp2(-m / 2) + m));
}

vec3 brdf_blinn_phong_exact(Angles a, vec3 cd, vec3 cs, real m) {
  return blinn_phong(a, cd, cs, m, blinn_phong_exact_scale(m));
}
