// SPDX-License-Identifier: Apache-2.0
// False colours of exposure: each band of stops (factors of 2) above and below 18 % grey has a colour of its
// own, linear for a display. Needs marks.glsl.
//   violet < -6 < blue < -4 < cyan < -2 < grey < -0.5 < green < 0.5 < light grey < 1.5 < yellow < 2.47 < red
// Red is above what a display without a tone curve can show: luminance 1 lies 2.47 stops above 18 %.
vec3 tone_false_color(vec3 scene) {
  real stops = log2(max(luminance_of(scene), real(1e-10)) / real(0.18));
  vec3 shown = vec3(real(0.07), real(0), real(0.15));
  if (stops >= real(-6)) shown = vec3(real(0), real(0.03), real(0.5));
  if (stops >= real(-4)) shown = vec3(real(0), real(0.28), real(0.42));
  if (stops >= real(-2)) shown = vec3(real(0.09));
  if (stops >= real(-0.5)) shown = vec3(real(0.03), real(0.4), real(0.05));
  if (stops >= real(0.5)) shown = vec3(real(0.42));
  if (stops >= real(1.5)) shown = vec3(real(0.85), real(0.62), real(0.02));
  if (stops >= real(2.4739312)) shown = vec3(real(0.8), real(0.01), real(0.01));
  return shown;
}
