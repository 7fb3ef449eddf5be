// SPDX-License-Identifier: Apache-2.0
// glTF 2.0, Appendix B (Khronos 2021): a dielectric mixes its body and its surface by the largest channel of F, with F0 of
// KHR_materials_ior and KHR_materials_specular; a metal has no body. In 1/sr.
//   cd, f0   diffuse colour and reflectance at normal incidence
//   alpha    width, roughness^2
vec3 brdf_as_gltf(Angles a, vec3 cd, vec3 f0, real alpha) {
  vec3 F = f_schlick(f0, a.lh);
  return brdf_lambert(a, cd) * (1 - largest_of(F)) +
         brdf_microfacet(F, d_ggx_s2(alpha, a.nh, a.s2), v_smith_ggx_height(a, alpha));
}
