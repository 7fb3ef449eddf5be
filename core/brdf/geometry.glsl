// SPDX-License-Identifier: Apache-2.0
// What the models need of two directions. Frame: normal +z, tangent +x.

const real pi = real(3.14159265358979323846);

//   nl, nv     cosines of light and viewer with the normal, in [-1, 1]
//   nh, lh     cosines of the half vector with the normal and with light (= with viewer)
//   lv         cosine between light and viewer
//   s2         |n x h|^2 = 1 - nh^2 without the cancellation
//   hu2, hv2   squares of the half vector's tangent and bitangent parts: hu2 + hv2 = s2
//   valid      above 0 where the models are defined (nl > 0, nv > 0, l is not -v), else 0
struct Angles {
  real nl;
  real nv;
  real nh;
  real lh;
  real lv;
  real s2;
  real hu2;
  real hv2;
  real valid;
};

Angles angles(vec3 l, vec3 v) {
  Angles a;
  vec3 s = l + v;
  real length2 = dot(s, s);
  real inverse = 1 / sqrt(max(length2, tiny));
  a.nl = clamp(l.z, real(-1), real(1));
  a.nv = clamp(v.z, real(-1), real(1));
  a.nh = clamp(s.z * inverse, real(-1), real(1));
  a.lh = min(sqrt(length2) / 2, real(1));
  a.lv = clamp(dot(l, v), real(-1), real(1));
  a.hu2 = s.x * inverse * s.x * inverse;
  a.hv2 = s.y * inverse * s.y * inverse;
  a.s2 = min(a.hu2 + a.hv2, real(1));
  a.valid = max(min(min(a.nl, a.nv), length2), real(0));
  return a;
}

// c^e for a cosine c and s2 = 1 - c^2 known without cancellation: neither c nor 1 - s2 carries the
// exponent 4096 in float near the lobe's peak. Floats stop at 2^-90 (power_floor), where an image sees
// nothing and subnormal numbers would cost threefold.
real power_of_cosine(real e, real c, real s2) {
  return exp2(max(e / 2 * log2_complement(c * c, s2), power_floor));
}
