// SPDX-License-Identifier: Apache-2.0
// Light from all around, integrated by samples each of which is filtered over the solid angle that it stands for.
// Based on:
//   Krivanek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling"

// The solid angle over which light is filtered, in that of a sample: with less, pixels differ by the places of their
// samples; with more, lobes are blurred.
const real refined_filter = real(0.5);

// The level of the map whose texels are as large as a solid angle; the level 0 has side * side texels.
//   sum   z of octahedral_place() for a unit vector
real light_map_level(real solid_angle, real sum, real side) {
  return log2(max(solid_angle * side * side / (4 * sum * sum * sum), real(1))) / 2;
}

// The place of octahedral_place() in the picture of all levels, in its texels: level 0 at the left, all others below
// each other beside it, each within a border of one texel.
//   level   whole
vec3 light_map_texel(vec3 place, real level, real side) {
  real size = side * exp2(-level);
  real left = level < real(0.5) ? real(1) : side + 3;
  real top = level < real(0.5) ? real(1) : side - 2 * size + 2 * level - 1;
  return vec3(left + place.x * size, top + place.y * size, real(0));
}

// The share of the upper hemisphere in the light that a sample stands for.
//   lz   cosine of the sample's direction and the axis
real refined_hemisphere_share(real lz, real solid_angle) {
  return hemisphere_share(lz, min(sqrt(solid_angle * real(0.31830988618379067154)), real(1)));
}

// A turn of the samples around the normal for each pixel, as a share of a whole turn in [0, 1): neighbours shall not
// have their samples at the same places.
real pixel_turn(uint column, uint row) {
  uint h = column * 0x9E3779B1u + row * 0x85EBCA77u;
  h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12u)) * 0x297A2D39u;
  h = h ^ (h >> 15u);
  return real(h >> 8u) * real(0.000000059604644775390625);
}
