// SPDX-License-Identifier: Apache-2.0
// A clear ball of radius 1 in its surroundings, by Snell and Fresnel: a ray is bent where it enters and, by as
// much, where it leaves. What is reflected inside and leaves later is left out: 0.2 % of the light in the
// middle of a ball of n = 1.5. Needs dielectric.glsl of core/fresnel.
//   nv    cosine of the viewer with the normal where the ray enters, [0, 1]
//   eta   index of the ball relative to what is around it, > 0

// Cosine of the ray inside with the normal; 0 beyond the critical angle of an index below 1.
real cosine_in_ball(real nv, real eta) {
  return sqrt(max(1 - (1 - nv * nv) / (eta * eta), real(0)));
}

// Direction in which the ray goes on behind the ball.
//   n, v   normal where it enters, and direction to the viewer: unit vectors
vec3 beyond_ball(vec3 n, vec3 v, real eta) {
  real nv = clamp(dot(n, v), real(0), real(1));
  real sine = sqrt(max(1 - nv * nv, real(0)));
  real inside = cosine_in_ball(nv, eta);
  // Of the angle by which the ray turns at each of the two surfaces.
  real turn_cosine = nv * inside + sine * sine / eta;
  real turn_sine = sine * inside - nv * sine / eta;
  real ahead = turn_cosine * turn_cosine - turn_sine * turn_sine;
  real aside = 2 * turn_cosine * turn_sine / max(sine, real(1e-6));
  return v * (-ahead) + (v * nv - n) * aside;
}

// Share of the light from there that reaches the viewer. The way inside is the cosine there, in diameters.
//   passing   what is left of light after a whole diameter, [0, 1]
//   twice     of light that passes the surface where it enters and where it leaves
vec3 through_layers(real nv, real eta, vec3 passing, vec3 twice) {
  real way = cosine_in_ball(nv, eta);
  return vec3(pow(passing.x, way), pow(passing.y, way), pow(passing.z, way)) * twice;
}

// The same of a ball without layers.
vec3 through_ball(real nv, real eta, vec3 passing) {
  real entered = 1 - fresnel_dielectric(real(1), eta, nv);
  return through_layers(nv, eta, passing, vec3(entered * entered));
}
