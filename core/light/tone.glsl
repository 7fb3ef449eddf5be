// SPDX-License-Identifier: Apache-2.0
// Tone curves: exposed scene light, linear sRGB, to what a display is to emit, linear in [0, 1]; the sRGB
// curve comes after them. Grey stays grey. Needs transfer.glsl.

vec3 at_least_black(vec3 c) {
  return vec3(max(c.x, real(0)), max(c.y, real(0)), max(c.z, real(0)));
}

vec3 at_most_white(vec3 c) {
  return vec3(min(c.x, real(1)), min(c.y, real(1)), min(c.z, real(1)));
}

// Khronos PBR Neutral Tone Mapper (2024), as its specification prints it: below 0.76 the colour itself less
// the 0.04 that a dielectric's surface adds, above it highlights compressed and drawn towards white. 18 %
// grey becomes 0.14, the code 105.
vec3 tone_neutral(vec3 scene) {
  vec3 color = at_least_black(scene);
  real least = min(color.x, min(color.y, color.z));
  real offset = least < real(0.08) ? least - real(6.25) * least * least : real(0.04);
  vec3 seen = color - vec3(offset);
  real peak = max(seen.x, max(seen.y, seen.z));
  real start = real(0.76);
  real room = 1 - start;
  real new_peak = 1 - room * room / (max(peak, start) + room - start);
  vec3 compressed = seen * (new_peak / max(peak, start));
  real whiter = 1 - 1 / (real(0.15) * (max(peak, start) - new_peak) + 1);
  return peak < start ? seen : mix(compressed, vec3(new_peak), whiter);
}

// A curve like AgX (Sobotka 2022) in form, with numbers of etak's own: colours are drawn towards grey, each
// channel goes by a curve over the logarithm, then the colours are drawn apart again. So bright saturated
// light fades to white instead of turning its hue. 18 % grey stays 0.18, the code 118, with the contrast that
// sRGB alone has there; white is reached 6.5 stops above it and black 10 stops below.
const real agx_stops_below = real(10);
const real agx_stops = real(16.5);
const real agx_slope = real(2.4);  // of the code over the range of stops, at middle grey
const real agx_inset = real(0.16);

// Of a branch of the curve that is to rise by `rise` where the straight line would rise by `run`, more than
// that.
real agx_scale(real run, real rise) {
  return run / pow(pow(run / rise, real(1.5)) - 1, real(2) / 3);
}

// The branch: slope 1 at 0, then bending.
real agx_bend(real t, real scale) {
  real u = t / scale;
  return t / pow(1 + pow(u, real(1.5)), real(2) / 3);
}

// One channel: linear to code.
real agx_code(real x) {
  real middle = agx_stops_below / agx_stops;
  real code = srgb_encode(real(0.18));
  real stops = log2(max(x, real(1e-10)) / real(0.18));
  real run = agx_slope * (clamp((stops + agx_stops_below) / agx_stops, real(0), real(1)) - middle);
  real above = agx_bend(max(run, real(0)), agx_scale(agx_slope * (1 - middle), 1 - code));
  real below = agx_bend(max(-run, real(0)), agx_scale(agx_slope * middle, code));
  return clamp(code + above - below, real(0), real(1));
}

vec3 tone_agx_like(vec3 scene) {
  vec3 color = at_least_black(scene);
  vec3 inset = mix(color, vec3((color.x + color.y + color.z) / 3), agx_inset);
  vec3 code = vec3(agx_code(inset.x), agx_code(inset.y), agx_code(inset.z));
  vec3 shown = vec3(srgb_decode(code.x), srgb_decode(code.y), srgb_decode(code.z));
  vec3 grey = vec3((shown.x + shown.y + shown.z) / 3);
  return at_most_white(at_least_black(grey + (shown - grey) / (1 - agx_inset)));
}
