// SPDX-License-Identifier: Apache-2.0
// Lambert: cd / pi. And the same with what the specular part leaves over (Hoffman's diffuse-specular
// tradeoff in the reciprocal form): cd / pi (1 - F(nl)) (1 - F(nv)) with Schlick's F. In 1/sr.
//   cd   diffuse colour, [0, 1]
//   f0   specular reflectance at normal incidence
vec3 brdf_lambert(Angles a, vec3 cd) {
  return cd * (1 / pi);
}

// The largest channel.
real largest_of(vec3 c) {
  return max(c.x, max(c.y, c.z));
}

// What F leaves: F0 above 1 (gold) leaves nothing.
vec3 left_over(vec3 F) {
  return vec3(max(1 - F.x, real(0)), max(1 - F.y, real(0)), max(1 - F.z, real(0)));
}

vec3 brdf_lambert_tradeoff(Angles a, vec3 cd, vec3 f0) {
  vec3 left = left_over(f0);
  return cd * left * left * (schlick_rest(a.nl) * schlick_rest(a.nv) * (1 / pi));
}
