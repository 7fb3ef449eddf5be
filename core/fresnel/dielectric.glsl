// SPDX-License-Identifier: Apache-2.0
// The lecture's pair for two clear media, light coming from the side of n1: total reflection beyond the
// critical angle. TU Graz, "Shading Models", Fresnel slides (correct as printed).
//   n1, n2   indices, > 0
//   c        cosine of incidence, [0, 1]
real fresnel_dielectric(real n1, real n2, real c) {
  // n2^2 times the square of the cosine beyond, below 0 beyond the critical angle.
  real beyond = (n2 - n1) * (n2 + n1) + n1 * c * (n1 * c);
  real ct = sqrt(max(beyond, real(0))) / n2;
  real es = n1 * c + n2 * ct;
  real ep = n1 * ct + n2 * c;
  real rs = (n1 * c - n2 * ct) / max(es, tiny);
  real rp = (n1 * ct - n2 * c) / max(ep, tiny);
  real value = (rs * rs + rp * rp) / 2;
  return beyond > 0 ? value : real(1);
}

vec3 fresnel_dielectric(vec3 n1, vec3 n2, real c) {
  return vec3(fresnel_dielectric(n1.x, n2.x, c), fresnel_dielectric(n1.y, n2.y, c), fresnel_dielectric(n1.z, n2.z, c));
}
