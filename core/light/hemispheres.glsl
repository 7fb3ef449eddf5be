// SPDX-License-Identifier: Apache-2.0
// Schueler 2009: light from two hemispheres of constant radiance, upper around the axis z and lower
// opposite to it.
//   lower, upper   radiance
//   nz             cosine of normal and axis
//   rz             cosine of the mirrored view direction and axis

vec3 hemisphere_diffuse(vec3 K, vec3 lower, vec3 upper, real nz) {
  return K * mix(lower, upper, (1 + nz) / 2);
}

// The share of the upper hemisphere in the lobe: 1/2 on the horizon, width w in the cosine; a step for w = 0.
real hemisphere_share(real rz, real w) {
  real wide = w > 0 ? clamp(rz / w, real(-1), real(1)) : (rz > 0 ? real(1) : (rz < 0 ? real(-1) : real(0)));
  return (1 + wide) / 2;
}

// Fresnel of a rough surface as seen by the hemispheres: the rise fades with gloss.
real hemisphere_fresnel(real K, real g, real nv) {
  real low = max(K, real(0));
  real m = 1 - clamp(nv, real(0), real(1));
  real m2 = m * m;
  return low + (min(60 * low, real(1)) - low) * g * (m2 * m2);
}

vec3 hemisphere_fresnel(vec3 K, real g, real nv) {
  return vec3(hemisphere_fresnel(K.x, g, nv), hemisphere_fresnel(K.y, g, nv), hemisphere_fresnel(K.z, g, nv));
}

// Corrected: the weight as a share in [0, 1], the Fresnel term of rough surfaces. The default.
vec3 hemisphere_specular(vec3 K, real g, real nv, real rz, vec3 lower, vec3 upper) {
  return hemisphere_fresnel(K, g, nv) * mix(lower, upper, hemisphere_share(rz, 1 - g));
}

// The same with a transition that never narrows to a step, min(1, 1.8 2^(-6 g)): rms error of the share
// 0.025 in place of 0.050 at g = 1, over axes all around.
vec3 hemisphere_specular_wide(vec3 K, real g, real nv, real rz, vec3 lower, vec3 upper) {
  real w = min(real(1), real(1.8) * exp2(-6 * g));
  return hemisphere_fresnel(K, g, nv) * mix(lower, upper, hemisphere_share(rz, w));
}

// As printed: weight clamp(rz / (1 - g), -1, 1) without the half, F(g nv). Negative below the horizon, and
// white on rough surfaces; kept to show it.
vec3 hemisphere_specular_printed(vec3 K, real g, real nv, real rz, vec3 lower, vec3 upper) {
  real share = 2 * hemisphere_share(rz, 1 - g) - 1;
  return f_schueler(K, g * nv) * mix(lower, upper, share);
}
