// SPDX-License-Identifier: Apache-2.0
// Stripes over what a validator would stop at: see struct Scene (core/render/scene.h).
const real too_much = real(1.01);  // what quick_albedo() and 8-bit textures are sure of

real luminance_of(vec3 c) {
  return real(0.2126) * c.x + real(0.7152) * c.y + real(0.0722) * c.z;
}

// Hoffman's forbidden zone (core/material/f0.h), of the luminance.
bool in_forbidden_zone(vec3 f0_value) {
  real y = luminance_of(f0_value);
  return y > real(0.20) && y < real(0.45);
}

// A surface whose two colours together send back more than comes.
bool sends_too_much(vec3 f0_value, vec3 body) {
  vec3 both = f0_value + body;
  return max(both.x, max(both.y, both.z)) > too_much;
}

// Stripes of 6 pixels at 45 degrees; `x` counts to the right, `y` down.
bool on_stripe(real x, real y) {
  real at = (x + y) / real(12) + real(4096);  // above 0 in any picture
  return at - real(int(at)) < real(0.499);
}

// The colour under a tint of Hoffman's zones: none where the normal is up to 45 degrees from the viewer and F barely
// changes, blue up to 75 degrees, where it changes, and orange from there, where it rushes to white.
vec3 with_angle_zones(vec3 seen, real nv, real exposure) {
  real lit = real(0.3) / max(exposure, real(1e-6));
  if (nv > real(0.70710678)) return seen;
  return real(0.6) * seen +
         (nv > real(0.25881905) ? vec3(0, real(0.3) * lit, lit) : vec3(lit, real(0.4) * lit, 0));
}

// The colour with its stripes: 0.6 of magenta (zone), or the other way round of yellow (energy), lit so that they
// show under the exposure.
vec3 with_stripes(vec3 seen, bool zone, bool energy, real x, real y, real exposure) {
  real lit = real(0.6) / max(exposure, real(1e-6));
  vec3 shown = seen;
  if (zone && on_stripe(x, y)) shown = real(0.4) * seen + vec3(lit, 0, lit);
  if (energy && on_stripe(x, -y)) shown = real(0.4) * seen + vec3(lit, real(0.8) * lit, 0);
  return shown;
}
