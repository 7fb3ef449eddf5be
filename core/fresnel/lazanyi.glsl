// SPDX-License-Identifier: Apache-2.0
// Lazanyi and Szirmay-Kalos 2005, "Fresnel Term Approximations for Metals": Schlick's rise over the exact
// F0, less an error term a c (1 - c)^alpha fitted per channel.
//   n, k       complex index
//   a, alpha   fitted, alpha > 0
//   c          cosine, clamped to [0, 1]
real f_lazanyi(real n, real k, real a, real alpha, real c) {
  real cc = clamp(c, real(0), real(1));
  real m = 1 - cc;
  real m2 = m * m;
  real power = pow(max(m, tiny), alpha);
  real dip = m > 0 ? power : real(0);
  return ((n - 1) * (n - 1) + 4 * n * (m2 * m2 * m) + k * k) / ((n + 1) * (n + 1) + k * k) - a * cc * dip;
}

vec3 f_lazanyi(vec3 n, vec3 k, vec3 a, vec3 alpha, real c) {
  return vec3(f_lazanyi(n.x, k.x, a.x, alpha.x, c), f_lazanyi(n.y, k.y, a.y, alpha.y, c),
              f_lazanyi(n.z, k.z, a.z, alpha.z, c));
}
