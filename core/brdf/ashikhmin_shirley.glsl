// SPDX-License-Identifier: Apache-2.0
// Ashikhmin and Shirley 2000, "An Anisotropic Phong BRDF Model", equations 4 and 5. The exponent of the
// lobe is 0/0 where the half vector is the normal: 0 there. In 1/sr.
//   rs, rd   specular and diffuse colour, [0, 1]
//   nu, nv   exponents along tangent (+x) and bitangent, >= 0
vec3 brdf_ashikhmin_shirley_specular(Angles a, vec3 rs, real nu, real nv) {
  real e = (nu * a.hu2 + nv * a.hv2) / max(a.s2, tiny);
  real lobe = sqrt((nu + 1) * (nv + 1)) / (8 * pi) * power_of_cosine(e, a.nh, a.s2);
  return brdf_microfacet(f_schlick(rs, a.lh), lobe, 1 / (a.lh * max(a.nl, a.nv)));
}

vec3 brdf_ashikhmin_shirley_diffuse(Angles a, vec3 rs, vec3 rd) {
  // 1 - (1 - nl / 2)^5 is Schlick's rest at nl / 2.
  real both = schlick_rest(a.nl / 2) * schlick_rest(a.nv / 2);
  return rd * left_over(rs) * (real(28) / (23 * pi) * both);
}

vec3 brdf_ashikhmin_shirley(Angles a, vec3 rd, vec3 rs, real nu, real nv) {
  return brdf_ashikhmin_shirley_specular(a, rs, nu, nv) + brdf_ashikhmin_shirley_diffuse(a, rs, rd);
}
