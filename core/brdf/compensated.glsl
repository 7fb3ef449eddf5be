// SPDX-License-Identifier: Apache-2.0
// Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks": what the facets reflect to each other comes
// back as (1 - E(l)) (1 - E(v)) / (pi (1 - mean of E)), where E is the directional albedo of one reflection of F = 1, times
// the colour of several reflections. Reciprocal, and Smith's masking stays as it is. Needs microfacet.glsl, lost_light.glsl.

// Gauss's rule for the mean over a diffuse hemisphere, the integral of 2 c F(c): exact for polynomials of degree 7, so
// that Schlick's mean is (1 + 20 F0) / 21 and those of F82 and of Schueler are exact too.
const real mean_cosine_1 = real(0.1397598643437805521);
const real mean_cosine_2 = real(0.4164095676310831799);
const real mean_cosine_3 = real(0.7231569863618761723);
const real mean_cosine_4 = real(0.9428958038854823178);

//   f1 ... f4   F at these cosines
vec3 mean_fresnel(vec3 f1, vec3 f2, vec3 f3, vec3 f4) {
  return f1 * real(0.06236194190001616435) + f2 * real(0.2596950952164646817) + f3 * real(0.4069291360205427216) + f4 * real(0.2710138268629762325);
}

// The sum of two and more reflections over that for F = 1.
//   F      mean of F; colours out of gamut are kept in [0, 1]
//   lost   mean of what one reflection of F = 1 loses
real further_reflections(real F, real lost) {
  real f = clamp(F, real(0), real(1));
  return f * f * (1 - lost) / (1 - f * lost);
}

//   V   G / (4 nl nv), the compensating lobe for F = 1, and the mean of what is lost
vec3 brdf_compensated(vec3 F, vec3 mean, real D, vec3 V) {
  return brdf_microfacet(F, D, V.x) + vec3(further_reflections(mean.x, V.z), further_reflections(mean.y, V.z),
                                           further_reflections(mean.z, V.z)) * V.y;
}

vec3 v_smith_ggx_compensated(Angles a, real alpha) {
  real mean = mean_lost_ggx(alpha);
  return vec3(v_smith_ggx_height(a, alpha),
              lost_ggx(a.nl, alpha) * lost_ggx(a.nv, alpha) / max(pi * mean, tiny), mean);
}

// Slopes above 1 lose no more than 1 does.
vec3 v_smith_beckmann_compensated(Angles a, real m) {
  real alpha = min(m, real(1));
  real mean = mean_lost_beckmann(alpha);
  return vec3(v_smith_beckmann_height(a, m),
              lost_beckmann(a.nl, alpha) * lost_beckmann(a.nv, alpha) / max(pi * mean, tiny), mean);
}
