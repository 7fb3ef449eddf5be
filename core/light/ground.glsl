// SPDX-License-Identifier: Apache-2.0
// A level ground that a ball of radius 1 lies on, in light that is the same from everywhere above: it has the
// colours of what is behind it, and the ball's shadow. So it needs no colour of its own, and no horizon.

// Share of the ground's irradiance that the ball keeps away, at the square of the distance from where it lies:
// the ball's form factor, cos / d^2 with d^2 = 1 + r^2 and cos = 1 / d (exact: it stands whole above the
// horizon).
real contact_shadow(real r2) {
  real d2 = 1 + r2;
  return 1 / (d2 * sqrt(d2));
}

// Share of light that is left where a ray from `eye` in direction `sight` meets the ground; 1 where it does
// not.
real ground_light(vec3 eye, vec3 sight) {
  real t = (eye.y + 1) / max(-sight.y, real(1e-4));
  real x = eye.x + sight.x * t;
  real z = eye.z + sight.z * t;
  return sight.y < 0 && eye.y > real(-1) ? 1 - contact_shadow(x * x + z * z) : real(1);
}
