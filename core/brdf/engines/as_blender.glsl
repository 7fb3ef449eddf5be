// SPDX-License-Identifier: Apache-2.0
// Blender 4, Principled BSDF, as Cycles' sources have it (kernel/svm/closure.h and kernel/closure/bsdf_microfacet.h, Apache-2.0):
// GGX, Smith height-correlated; a metal's F82-tint; a dielectric's F of its index, scaled to F0; what facets reflect to each other
// as 1 + Fms (1 - E) / E with Fms = Fss Em / (1 - Fss (1 - Em)); below it Lambert times what the surface leaves. Cycles reads
// E and its mean Em, the albedo for F = 1, from tables of samples; here they are those of lost_light.glsl, at most 0.0071 off. What
// the surface leaves is a table too; here it is that of the mirror, 1 - F(nv) E with the same factor. In 1/sr.
//   cd, f0, f82   diffuse colour, reflectance at normal incidence and at cosine 1/7
//   alpha         width, roughness^2
//   metallic      share of the metal, [0, 1]

// E times 1 + Fms (1 - E) / E for a mean F of `mean`.
real blender_energy(real mean, real e, real em) {
  real f = clamp(mean, real(0), real(1));
  return e + f * em / (1 - f * (1 - em)) * (1 - e);
}
vec3 blender_energy(vec3 mean, real e, real em) {
  return vec3(blender_energy(mean.x, e, em), blender_energy(mean.y, e, em), blender_energy(mean.z, e, em));
}

vec3 brdf_as_blender(Angles a, vec3 cd, vec3 f0, vec3 f82, real alpha, real metallic) {
  real e = 1 - lost_ggx(a.nv, alpha);
  real em = 1 - mean_lost_ggx(alpha);
  real dv = d_ggx_s2(alpha, a.nh, a.s2) * v_smith_ggx_height(a, alpha) / e;
  vec3 mean_metal = vec3(f82_mean(f0.x, f82.x), f82_mean(f0.y, f82.y), f82_mean(f0.z, f82.z));
  vec3 metal = brdf_microfacet(f_f82(f0, f82, a.lh), dv, real(1)) * blender_energy(mean_metal, e, em);
  // The index is one number: that of the mean F0.
  real own = clamp((f0.x + f0.y + f0.z) / 3, real(1e-6), real(0.99));
  real eta = (1 + sqrt(own)) / (1 - sqrt(own));
  real lit = (f_from_f0(own, a.lh) - own) / (1 - own);
  real seen = (f_from_f0(own, a.nv) - own) / (1 - own);
  real whole = clamp(((eta - 1) / (real(4.08567) + real(1.00071) * eta) - own) / (1 - own), real(0), real(1));
  vec3 rest = vec3(1) - f0;
  vec3 energy = blender_energy(f0 + rest * whole, e, em);
  vec3 clear = brdf_microfacet(f0 + rest * lit, dv, real(1)) * energy;
  real left = max(1 - largest_of((f0 + rest * seen) * energy), real(0));
  return mix(brdf_lambert(a, cd) * left + clear, metal, metallic);
}
