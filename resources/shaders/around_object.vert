// SPDX-License-Identifier: Apache-2.0
// A fan around the object: what it does not cover is never shaded. Needs no vertex data.
//   fan_centre, fan_radius   in the target's coordinates, -1 to 1
//   fan_corners              how many; the first lies at 45 degrees of four, so that those make an upright square
uniform vec2 fan_centre;
uniform vec2 fan_radius;
uniform float fan_corners;

void main() {
  float angle = (float(gl_VertexID) + 0.5) * 6.283185307179586 / fan_corners;
  gl_Position = vec4(fan_centre + fan_radius * vec2(cos(angle), sin(angle)), 0.0, 1.0);
}
