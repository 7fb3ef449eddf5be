// SPDX-License-Identifier: Apache-2.0
// Guy and Agopian, "Physically Based Rendering in Filament" (google.github.io/filament), sections 4.4 to 4.7: GGX, Smith
// height-correlated, Schlick with F90 = saturate(16.5 (r + g + b)), Lambert, and 1 + F0 (1 / E - 1) for what facets reflect to
// each other. The engine reads E, the directional albedo for F = 1, from a table of samples; here it is that of lost_light.glsl,
// at most 0.0071 off. In 1/sr.
//   cd, f0   diffuse colour and reflectance at normal incidence
//   alpha    width, roughness^2; held at a roughness of 0.045
vec3 brdf_as_filament(Angles a, vec3 cd, vec3 f0, real alpha) {
  real width = max(alpha, real(0.002025));
  real f90 = clamp(real(16.5) * (f0.x + f0.y + f0.z), real(0), real(1));
  vec3 F = f0 + (vec3(f90) - f0) * schlick_rise(a.lh);
  real again = 1 / (1 - lost_ggx(a.nv, width)) - 1;
  vec3 surface = brdf_microfacet(F, d_ggx_s2(width, a.nh, a.s2), v_smith_ggx_height(a, width));
  return brdf_lambert(a, cd) + surface * (vec3(1) + f0 * again);
}
