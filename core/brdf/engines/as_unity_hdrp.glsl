// SPDX-License-Identifier: Apache-2.0
// Unity High Definition Render Pipeline, Material/Lit/Lit.hlsl and ShaderLibrary/BSDF.hlsl (github.com/Unity-Technologies/Graphics):
// GGX, Smith height-correlated, Schlick; Burley's diffuse term (2012) over 1.03571; and what facets reflect to each other as
// Turquin 2019, 1 + F0 (1 / E - 1). The engine reads E, the directional albedo for F = 1, from a table of samples; here it is
// that of lost_light.glsl, at most 0.0071 off. In 1/sr.
//   cd, f0   diffuse colour, which F0's largest channel takes from (specular colour), and reflectance at normal incidence
//   alpha    width, roughness^2; held at 1/1024 as for single lights
vec3 brdf_as_unity_hdrp(Angles a, vec3 cd, vec3 f0, real alpha) {
  real width = max(alpha, real(1) / 1024);
  real rough = sqrt(alpha);
  real rise = real(0.5) + rough + rough * a.lv - 1;
  real body = (1 + rise * schlick_rise(a.nl)) * (1 + rise * schlick_rise(a.nv)) / real(1.03571);
  real again = 1 / (1 - lost_ggx(a.nv, width)) - 1;
  vec3 surface = brdf_microfacet(f_schlick(f0, a.lh), d_ggx_s2(width, a.nh, a.s2), v_smith_ggx_height(a, width));
  return brdf_lambert(a, cd) * (max(1 - largest_of(f0), real(0)) * body) + surface * (vec3(1) + f0 * again);
}
