// SPDX-License-Identifier: Apache-2.0
// Samples of the ambient light of a refined picture: see core/light/refined.glsl and struct RefinedLight
// (core/render/ambient/light_map.h).
uniform float light_map_side;
uniform float light_map_last;

// The mean radiance over a solid angle around d, a direction of the map.
vec3 light_map_around(sampler2D map, vec3 d, float solid_angle) {
  vec3 place = octahedral_place(d);
  float level = min(light_map_level(solid_angle * refined_filter, place.z, light_map_side), light_map_last);
  float sharp = floor(level);
  vec2 size = vec2(textureSize(map, 0));
  vec3 near = texture(map, light_map_texel(place, sharp, light_map_side).xy / size).xyz;
  if (level == sharp) return near;
  return mix(near, texture(map, light_map_texel(place, sharp + 1.0, light_map_side).xy / size).xyz, level - sharp);
}

// The share of the upper hemisphere, with the same filter.
float sky_share_around(float lz, float solid_angle) {
  return refined_hemisphere_share(lz, solid_angle * refined_filter);
}

// From the map of an environment that is turned around y.
vec3 turned_from_map(vec3 d, vec2 turn) {
  return vec3(d.x * turn.x + d.z * turn.y, d.y, d.z * turn.x - d.x * turn.y);
}

// A column of the samples, turned around the normal.
//   turn   cosine and sine
vec4 turned_sample(sampler2D samples, int column, int row, vec2 turn) {
  vec4 s = texelFetch(samples, ivec2(column, row), 0);
  return vec4(s.x * turn.x - s.y * turn.y, s.x * turn.y + s.y * turn.x, s.z, s.w);
}
