// SPDX-License-Identifier: Apache-2.0
// Light from all around by a model's own directional albedo and by a few round lobes that stand for its lobe: the numbers are
// those of AmbientTable (core/render/ambient/ambient.h).

// The axis of a round lobe, not of unit length.
//   tilt   0: along the normal; 1: along the mirrored viewer
vec3 probe_axis(vec3 n, vec3 v, real nv, real tilt) {
  return n * (1 - tilt + 2 * tilt * nv) - v * tilt;
}

// A tangent in the plane of normal and viewer; where these are the same, any.
vec3 viewer_tangent(vec3 n, vec3 v, real nv) {
  vec3 along = v - n * nv;
  vec3 other = abs(n.x) < real(0.6) ? vec3(1, 0, 0) - n * n.x : vec3(0, 1, 0) - n * n.y;
  vec3 t = dot(along, along) > real(1e-8) ? along : other;
  return t / sqrt(dot(t, t));
}

// The mirrored viewer of a half vector.
//   h   in the frame of tangent t, bitangent b and normal n; of any length, whose square the result has
vec3 sample_axis(vec3 h, vec3 t, vec3 b, vec3 n, vec3 v) {
  vec3 w = t * h.x + b * h.y + n * h.z;
  return w * (2 * dot(w, v)) - v * dot(h, h);
}

// The directional albedo where F0 follows a texture.
//   c   coefficients of 1, F0 and F0^2
vec3 albedo_of_f0(vec3 c, vec3 F0) {
  return vec3(max(c.x + F0.x * (c.y + F0.x * c.z), real(0)), max(c.x + F0.y * (c.y + F0.y * c.z), real(0)),
              max(c.x + F0.z * (c.y + F0.z * c.z), real(0)));
}

// The share of a round lobe that lies beyond a plane: at most 0.022 off.
//   z       cosine of the lobe's axis and the normal of the plane
//   level   of the lobe: its exponent is 2^(12 - 1.5 level)
real probe_share(real z, real level) {
  real w = min(real(5.15) / sqrt(exp2(12 - real(1.5) * level) + 2), real(1));
  real t = clamp(z / w, real(-1), real(1));
  real t2 = t * t;
  real smooth_step = t * (15 - t2 * (10 - 3 * t2)) / 8;
  return (1 + mix(smooth_step, t, clamp((level - 5) / 2, real(0), real(1)))) / 2;
}

// The place of a direction of any length but 0 on the square of an octahedral map, both coordinates in [0, 1]: the eight
// faces of an octahedron around the direction +y in the middle.
vec3 octahedral_place(vec3 d) {
  real scale = real(0.5) / max(abs(d.x) + abs(d.y) + abs(d.z), tiny);
  real x = d.x * scale;
  real z = d.z * scale;
  real over_x = (real(0.5) - abs(z)) * (x < 0 ? real(-1) : real(1));
  real over_z = (real(0.5) - abs(x)) * (z < 0 ? real(-1) : real(1));
  return vec3((d.y < 0 ? over_x : x) + real(0.5), (d.y < 0 ? over_z : z) + real(0.5), real(0));
}

// The direction of a place on that square; beyond an edge the map is mirrored at the middle of the edge.
vec3 octahedral_direction(real u, real v) {
  real x = 2 * u - 1;
  real z = 2 * v - 1;
  real over_x = abs(x) > 1 ? (x < 0 ? real(-2) : real(2)) - x : x;
  real far_z = abs(x) > 1 ? -z : z;
  real over_z = abs(far_z) > 1 ? (far_z < 0 ? real(-2) : real(2)) - far_z : far_z;
  real far_x = abs(far_z) > 1 ? -over_x : over_x;
  real y = 1 - abs(far_x) - abs(over_z);
  real down_x = (1 - abs(over_z)) * (far_x < 0 ? real(-1) : real(1));
  real down_z = (1 - abs(far_x)) * (over_z < 0 ? real(-1) : real(1));
  return vec3(y < 0 ? down_x : far_x, y, y < 0 ? down_z : over_z);
}
