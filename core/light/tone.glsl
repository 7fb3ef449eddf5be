// SPDX-License-Identifier: Apache-2.0
// Tone curves: exposed scene light, linear sRGB, to what a display is to emit, linear in [0, 1]; the sRGB
// curve comes after them. Grey stays grey, but with Filament's curve. Needs transfer.glsl.

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

// The tone curve of Filament where it is told of no other, ACESLegacy (ToneMapper.cpp, ColorSpaceUtils.h): the reference
// rendering transform of ACES 1.0 (AMPAS 2014) with its glow, its turn of reds and its loss of saturation, then a
// rational fit of its curve for a monitor of 100 nits in dim surround. Filament goes to the spaces of ACES and back without
// adapting the white point, which warms greys: 18 % grey becomes the codes 128, 129, 129 and white 230, 226, 220.
real aces_luminance(vec3 ap1) {
  return dot(vec3(real(0.272229), real(0.674082), real(0.0536895)), ap1);
}
vec3 aces_ap0_of_srgb(vec3 c) {
  return vec3(dot(vec3(real(0.4329984643), real(0.3753732176), real(0.1893330539)), c),
              dot(vec3(real(0.0894280027), real(0.8165151141), real(0.1029970741)), c),
              dot(vec3(real(0.0191647675), real(0.1181492658), real(0.9419907473)), c));
}
vec3 aces_ap1_of_ap0(vec3 c) {
  return vec3(dot(vec3(real(1.4514393161), real(-0.2365107469), real(-0.2149285693)), c),
              dot(vec3(real(-0.0765537734), real(1.1762296998), real(-0.0996759264)), c),
              dot(vec3(real(0.0083161484), real(-0.0060324498), real(0.9977163014)), c));
}
vec3 aces_srgb_of_ap1(vec3 c) {
  return vec3(dot(vec3(real(1.7309766651), real(-0.603954334), real(-0.0800951104)), c),
              dot(vec3(real(-0.1316215137), real(1.1348699455), real(-0.0086795887)), c),
              dot(vec3(real(-0.0245741814), real(-0.1257807634), real(1.0658927035)), c));
}

// 0 to 1 where x goes from -2 to 2.
real aces_sigmoid(real x) {
  real t = max(1 - abs(x / 2), real(0));
  return x < 0 ? t * t / 2 : 1 - t * t / 2;
}

// By how much dark saturated colours glow.
real aces_glow(vec3 ap0, real saturation) {
  real chroma = sqrt(max(ap0.z * (ap0.z - ap0.y) + ap0.y * (ap0.y - ap0.x) + ap0.x * (ap0.x - ap0.z), real(0)));
  real light = (ap0.x + ap0.y + ap0.z + real(1.75) * chroma) / 3;
  real middle = real(0.08);
  real share = clamp(middle / max(light, tiny) - real(0.5), real(0), real(1));
  return real(0.05) * aces_sigmoid((saturation - real(0.4)) / real(0.2)) * share;
}

// 1 for the hue of red, 0 from 67.5 degrees of it.
real aces_red_share(vec3 ap0) {
  real along = 2 * ap0.x - ap0.y - ap0.z;
  if (along <= 0) return real(0);
  real degrees = real(57.29577951308232) * atan(real(1.7320508075688772) * abs(ap0.y - ap0.z) / along);
  real near = max(1 - 2 * degrees / 135, real(0));
  real share = near * near * (3 - 2 * near);
  return share * share;
}

// The rational fit of the curve, one channel.
real aces_curve(real x) {
  return x * (real(2.785085) * x + real(0.107772)) / (x * (real(2.936045) * x + real(0.887122)) + real(0.806889));
}

vec3 tone_filament(vec3 scene) {
  vec3 ap0 = aces_ap0_of_srgb(scene);
  real least = min(ap0.x, min(ap0.y, ap0.z));
  real most = max(ap0.x, max(ap0.y, ap0.z));
  real saturation = (max(most, real(1e-5)) - max(least, real(1e-5))) / max(most, real(0.01));
  ap0 = ap0 * (1 + aces_glow(ap0, saturation));
  ap0.x = ap0.x + aces_red_share(ap0) * saturation * (real(0.03) - ap0.x) * (1 - real(0.82));
  vec3 ap1 = aces_ap1_of_ap0(ap0);
  ap1 = vec3(clamp(ap1.x, real(0), real(65504)), clamp(ap1.y, real(0), real(65504)), clamp(ap1.z, real(0), real(65504)));
  ap1 = mix(vec3(aces_luminance(ap1)), ap1, real(0.96)) / real(0.6);
  vec3 shown = vec3(aces_curve(ap1.x), aces_curve(ap1.y), aces_curve(ap1.z));
  // From dark to dim surround.
  shown = shown * pow(max(aces_luminance(shown), tiny), real(0.9811) - 1);
  shown = mix(vec3(aces_luminance(shown)), shown, real(0.93));
  return at_most_white(at_least_black(aces_srgb_of_ap1(shown)));
}
