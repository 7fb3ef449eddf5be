// SPDX-License-Identifier: Apache-2.0
// Schueler 2009, "An Efficient and Physically Plausible Real-Time Shading Model": his four techniques as
// f_r in 1/sr (the printed value is pi f_r nl per unit of his pi-scaled irradiance).
//   K   specular colour
//   g   gloss, [0, 1]
// D is printed (1 + e)/2 nh^e; D / pi integrates to (1 + e)/(2 + e), a loss of 33 % at g = 0 and 1.5 % at
// g = 0.5.

// Each comes twice: as a function of what is the same for a whole surface, and of K and g.

struct SchuelerSurface {
  SchuelerEnds F;
  real e;
};

SchuelerSurface schueler_surface(vec3 K, real g) {
  SchuelerSurface surface;
  surface.F = schueler_ends(K);
  surface.e = gloss_exponent(g);
  return surface;
}

// CookTorranceSimplified: D F G / (4 nv).
vec3 schueler_simplified(Angles a, SchuelerSurface s) {
  return f_schueler(s.F, a.lh) * (d_schueler_s2(s.e, a.nh, a.s2) * v_cook_torrance(a) * (1 / pi));
}

vec3 brdf_schueler_simplified(Angles a, vec3 K, real g) {
  return schueler_simplified(a, schueler_surface(K, g));
}

// KelemenSzirmayKalos: D F nl / (4 lh^2).
vec3 schueler_ksk(Angles a, SchuelerSurface s) {
  return f_schueler(s.F, a.lh) * (d_schueler_s2(s.e, a.nh, a.s2) * v_kelemen(a) * (1 / pi));
}

vec3 brdf_schueler_ksk(Angles a, vec3 K, real g) {
  return schueler_ksk(a, schueler_surface(K, g));
}

// Optimized: K (1 + e) / (8 lh^3) nh^e nl. Its hidden Fresnel K / lh passes 1 for lh < K: albedo about K /
// cos(theta).
vec3 schueler_optimized(Angles a, vec3 K, real e) {
  vec3 low = vec3(max(K.x, real(0)), max(K.y, real(0)), max(K.z, real(0)));
  return low * (d_schueler_s2(e, a.nh, a.s2) / (4 * pi * a.lh * a.lh * a.lh));
}

vec3 brdf_schueler_optimized(Angles a, vec3 K, real g) {
  return schueler_optimized(a, K, gloss_exponent(g));
}

// The same with K / lh kept at or below 1: albedo at most 0.9993 for K up to 1.
vec3 schueler_optimized_bounded(Angles a, vec3 K, real e) {
  real inverse = 1 / max(a.lh, tiny);
  vec3 F = vec3(clamp(K.x * inverse, real(0), real(1)), clamp(K.y * inverse, real(0), real(1)),
                clamp(K.z * inverse, real(0), real(1)));
  return F * (d_schueler_s2(e, a.nh, a.s2) * v_kelemen(a) * (1 / pi));
}

vec3 brdf_schueler_optimized_bounded(Angles a, vec3 K, real g) {
  return schueler_optimized_bounded(a, K, gloss_exponent(g));
}

// CookTorranceFull: Beckmann of the width that fits the exponent, exact F, G.
vec3 schueler_full(Angles a, vec3 n, vec3 k, real m) {
  return fresnel_exact(n, k, a.lh) * (d_beckmann_s2(m, a.nh, a.s2) * v_cook_torrance(a));
}

vec3 brdf_schueler_full(Angles a, vec3 n, vec3 k, real g) {
  return schueler_full(a, n, k, exponent_alpha(gloss_exponent(g)));
}
