// SPDX-License-Identifier: Apache-2.0
// A strip around the object, from a polygon inside its edge to one beyond the picture: the backdrop that the object
// does not hide. Needs no vertex data.
//   fan_centre, fan_radius   of the inner polygon, in the target's coordinates, -1 to 1
//   fan_corners              how many it has; the strip ends where it began
//   ring_factor              of its radius: that of the outer polygon
uniform vec2 fan_centre;
uniform vec2 fan_radius;
uniform float fan_corners;
uniform float ring_factor;

void main() {
  float angle = float(gl_VertexID / 2) * 6.283185307179586 / fan_corners;
  float factor = (gl_VertexID & 1) == 0 ? 1.0 : ring_factor;
  gl_Position = vec4(fan_centre + fan_radius * factor * vec2(cos(angle), sin(angle)), 0.0, 1.0);
}
