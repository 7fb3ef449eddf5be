// SPDX-License-Identifier: Apache-2.0
// From a pixel to the surface: see struct Scene (core/render/scene.h).
//   at      the pixel's place, in radii of the sphere's silhouette
//   pixel   size of a pixel, in the same

// Share of the pixel inside the unit circle, by its distance from the edge.
float disc_coverage(vec2 at, float pixel) {
  return clamp(0.5 + (1.0 - length(at)) / pixel, 0.0, 1.0);
}

// The same for a square whose sides lie at +-side.
float square_coverage(vec2 at, float side, float pixel) {
  vec2 inside = clamp(0.5 + (side - abs(at)) / pixel, 0.0, 1.0);
  return inside.x * inside.y;
}

// A pixel that the edge crosses is shaded at the nearest point inside.
vec2 drawn_in(vec2 at) {
  return at * min(1.0, 0.9999 / max(length(at), 1e-6));
}

vec3 sphere_orthographic(vec2 at) {
  vec2 p = drawn_in(at);
  return vec3(p, sqrt(1.0 - dot(p, p)));
}

// The camera looks along -z from (0, 0, distance), the ray is (at * spread, -1): `spread` is the tangent of
// the silhouette's half-angle, and the root of the discriminant is the orthographic depth.
vec3 sphere_perspective(vec2 at, float distance_to_centre, float spread) {
  vec2 p = drawn_in(at);
  float r2 = dot(p, p);
  float t = (distance_to_centre - sqrt(1.0 - r2)) / (1.0 + r2 * spread * spread);
  return vec3(p * (spread * t), distance_to_centre - t);
}

// To the viewer from what is seen at `at`.
vec3 viewer_perspective(vec2 at, float spread) {
  return normalize(vec3(-at * spread, 1.0));
}

// Tangent of the surface: along the circle of latitude around y, the x axis at its poles.
vec3 tangent_of(vec3 n) {
  vec3 across = vec3(n.z, 0.0, -n.x);
  float length2 = dot(across, across);
  return length2 < 1e-12 ? vec3(1.0, 0.0, 0.0) : across * inversesqrt(length2);
}

// The normal that a texel m of a normal map gives, in the frame of n. One that would turn away from the viewer is held at
// 0.02 of its cosine, so that no light comes through the edge of the object. C++: bend_normals() of shade_picture.h.
vec3 bent_normal(vec3 n, vec3 v, vec3 m) {
  vec3 along = tangent_of(n);
  vec3 bent = normalize(m.x * along + m.y * cross(n, along) + m.z * n);
  float facing = dot(bent, v);
  return facing < 0.02 ? normalize(bent + (0.02 - facing) * v) : bent;
}

// The same as angles() (brdf/geometry.glsl) around the normal n, without a frame: for lobes that know no tangent.
Angles angles_about(vec3 n, vec3 l, vec3 v) {
  Angles a;
  vec3 s = l + v;
  float length2 = dot(s, s);
  float inverse = 1.0 / sqrt(max(length2, tiny));
  vec3 across = cross(n, s) * inverse;
  a.nl = clamp(dot(n, l), -1.0, 1.0);
  a.nv = clamp(dot(n, v), -1.0, 1.0);
  a.nh = clamp(dot(n, s) * inverse, -1.0, 1.0);
  a.lh = min(sqrt(length2) / 2.0, 1.0);
  a.lv = clamp(dot(l, v), -1.0, 1.0);
  a.s2 = min(dot(across, across), 1.0);
  a.valid = max(min(min(a.nl, a.nv), length2), 0.0);
  return a;
}

// `w` in the frame of tangent, bitangent and normal.
vec3 in_frame(vec3 w, vec3 t, vec3 b, vec3 n) {
  return vec3(dot(w, t), dot(w, b), dot(w, n));
}

// From the camera's axes (right, up, towards the camera) to the scene's.
vec3 out_of_camera(vec3 w, vec3 right, vec3 up, vec3 back) {
  return w.x * right + w.y * up + w.z * back;
}

// A square that is not seen from the front: see Camera::plane() (core/render/camera.h) for the rows.
//   place   on the square, at times w in front of the camera
vec3 plane_place(vec2 at, vec3 row_x, vec3 row_y, vec3 row_w) {
  vec3 h = vec3(at, 1.0);
  return vec3(dot(row_x, h), dot(row_y, h), dot(row_w, h));
}

float plane_coverage(vec3 place, float facing, vec3 row_x, vec3 row_y, vec3 row_w, float pixel) {
  if (abs(facing) < 1e-3 || place.z <= 1e-6) return 0.0;
  vec2 on = place.xy / place.z;
  float slope_x = length(row_x.xy - on.x * row_w.xy);
  float slope_y = length(row_y.xy - on.y * row_w.xy);
  vec2 margin = (1.0 - abs(on)) * place.z / max(vec2(slope_x, slope_y), vec2(1e-6));
  vec2 inside = clamp(0.5 + margin / pixel, 0.0, 1.0);
  return inside.x * inside.y;
}

// Places in a texture: texture_place() of core/render/surface_textures.h.
vec2 square_texel(vec3 p) {
  return vec2(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.y);
}

vec2 sphere_texel(vec3 p) {
  const float turn = 6.283185307179586;
  float around = abs(p.x) + abs(p.z) > 0.0 ? atan(p.x, p.z) : 0.0;
  return vec2(0.5 + around / turn, atan(length(p.xz), p.y) * 2.0 / turn);
}
