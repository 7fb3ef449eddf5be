// SPDX-License-Identifier: Apache-2.0
// Light from all around, prefiltered: see class Environment (core/render/environment.h). Lat-long maps whose
// first row looks up, and octahedral ones.
uniform sampler2D environment_irradiance;
uniform sampler2D environment_levels;  // nine octahedral maps below each other, from the sharpest to the dullest

// With atan for both angles: acos loses its digits towards the poles.
vec3 lat_long(sampler2D map, vec3 d) {
  const float turn = 6.283185307179586;
  float around = abs(d.x) + abs(d.z) > 0.0 ? atan(d.x, -d.z) : 0.0;
  float down = atan(length(d.xz), d.y);
  return texture(map, vec2(0.5 + around / turn, down * 2.0 / turn)).xyz;
}

// Radiance of a white diffuse surface with normal n.
vec3 environment_diffuse(vec3 n) {
  return lat_long(environment_irradiance, n) * 0.3183098861837907;
}

// Radiance through the round lobe of a level around r, of any length; linear between the levels. Each map is a tile of the
// texture with a border of one texel.
vec3 environment_specular(vec3 r, float level) {
  const float tile = 160.0;
  float first = clamp(floor(level), 0.0, 7.0);
  vec2 at = (octahedral_place(r).xy * (tile - 2.0) + 1.0) / tile;
  at.y = (at.y + first) / 9.0;
  return mix(texture(environment_levels, at).xyz, texture(environment_levels, at + vec2(0.0, 1.0 / 9.0)).xyz,
             clamp(level - first, 0.0, 1.0));
}

// The same for the samples of a refined picture: see struct LightSamples (core/render/ambient/light_samples.h).
uniform sampler2D environment_samples;
vec3 environment_sample(vec3 r, float level) {
  const float tile = 322.0;
  float first = clamp(floor(level) + 2.0, 0.0, 9.0);
  vec2 at = (octahedral_place(r).xy * (tile - 2.0) + 1.0) / tile;
  at.y = (at.y + first) / 11.0;
  return mix(texture(environment_samples, at).xyz, texture(environment_samples, at + vec2(0.0, 1.0 / 11.0)).xyz,
             clamp(level + 2.0 - first, 0.0, 1.0));
}

// What is seen behind the object: two maps between which the blur lies, and the share of the duller one.
uniform sampler2D backdrop_sharp;
uniform sampler2D backdrop_dull;
uniform float backdrop_share;

vec3 environment_behind(vec3 d) {
  return mix(lat_long(backdrop_sharp, d), lat_long(backdrop_dull, d), backdrop_share);
}

// To the map of an environment that is turned around y.
//   turn   cosine and sine
vec3 turned_to_map(vec3 d, vec2 turn) {
  return vec3(d.x * turn.x - d.z * turn.y, d.y, d.x * turn.y + d.z * turn.x);
}
