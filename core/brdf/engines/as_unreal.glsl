// SPDX-License-Identifier: Apache-2.0
// Karis 2013, "Real Shading in Unreal Engine 4" (notes of the SIGGRAPH course Physically Based Shading in Theory and Practice):
// GGX of alpha = roughness^2, Schlick's masking with k = (roughness + 1)^2 / 8 as it is for single lights, Schlick's F with a
// spherical Gaussian, Lambert. In 1/sr. What versions after 4 changed is published to licensees alone.
//   cd, f0   diffuse colour and reflectance at normal incidence
//   alpha    width, roughness^2
vec3 brdf_as_unreal(Angles a, vec3 cd, vec3 f0, real alpha) {
  real rough = sqrt(alpha) + 1;
  real k = rough * rough / 8;
  real v = real(0.25) / ((a.nl * (1 - k) + k) * (a.nv * (1 - k) + k));
  return brdf_lambert(a, cd) + brdf_microfacet(f_spherical_gaussian(f0, a.lh), d_ggx_s2(alpha, a.nh, a.s2), v);
}
