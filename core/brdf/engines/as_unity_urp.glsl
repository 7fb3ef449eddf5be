// SPDX-License-Identifier: Apache-2.0
// Unity Universal Render Pipeline, ShaderLibrary/BRDF.hlsl (github.com/Unity-Technologies/Graphics), DirectBRDFSpecular: a fit of
// GGX, Smith and F by Karis 2013, "Optimizing PBR for Mobile", in which F does not rise. Its lights hold pi, so that the sum is
// over pi. In 1/sr.
//   cd, f0   diffuse colour, which F0's largest channel takes from (specular setup), and reflectance at normal incidence
//   alpha    width, roughness^2; held at 2^-7, the root of the smallest half
vec3 brdf_as_unity_urp(Angles a, vec3 cd, vec3 f0, real alpha) {
  real r2 = max(alpha, real(0.0078125)) * max(alpha, real(0.0078125));
  real d = a.nh * a.nh * (r2 - 1) + real(1.00001);
  real lobe = r2 / (d * d * max(real(0.1), a.lh * a.lh) * (4 * sqrt(r2) + 2));
  return (cd * max(1 - largest_of(f0), real(0)) + f0 * lobe) * (1 / pi);
}
