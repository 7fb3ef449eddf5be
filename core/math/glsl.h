// SPDX-License-Identifier: Apache-2.0
// No include guard: this file gives a namespace the part of GLSL that etak's formula texts (*.glsl) use.
// Include it inside a namespace that has the type `real` and the constant `tiny`; the names here hide the
// standard ones.
// clang-format off
// NOLINTBEGIN
struct vec3 {
  real x, y, z;
  vec3() : x(0), y(0), z(0) {}
  explicit vec3(real all) : x(all), y(all), z(all) {}
  vec3(real x_, real y_, real z_) : x(x_), y(y_), z(z_) {}
};
inline vec3 operator+(vec3 a, vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline vec3 operator-(vec3 a, vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline vec3 operator*(vec3 a, vec3 b) { return vec3(a.x * b.x, a.y * b.y, a.z * b.z); }
inline vec3 operator*(vec3 a, real s) { return vec3(a.x * s, a.y * s, a.z * s); }
inline vec3 operator*(real s, vec3 a) { return vec3(a.x * s, a.y * s, a.z * s); }
inline vec3 operator/(vec3 a, real s) { return vec3(a.x / s, a.y / s, a.z / s); }
#ifdef ETAK_POLYNOMIALS  // float only, for loops that shall run in vector lanes
#include "core/math/polynomials.h"
#else
inline real min(real a, real b) { return b < a ? b : a; }
inline real max(real a, real b) { return a < b ? b : a; }
#endif
inline real clamp(real x, real lo, real hi) { return min(max(x, lo), hi); }
inline real mix(real a, real b, real t) { return a * (1 - t) + b * t; }
inline vec3 mix(vec3 a, vec3 b, real t) { return a * (1 - t) + b * t; }
inline real dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
#ifndef ETAK_POLYNOMIALS
inline real abs(real x) { return std::abs(x); }
inline real sqrt(real x) { return std::sqrt(x); }
inline real pow(real x, real e) { return math::pow(x, e); }
inline real exp2(real x) { return math::exp2(x); }
inline real log(real x) { return math::log(x); }
inline real log2(real x) { return math::log2(x); }
inline real erf(real x) { return math::erf(x); }
inline real atan(real x) { return math::atan(x); }
#ifdef ETAK_POLYNOMIALS_F64  // double, for such loops
#include "core/math/polynomials_f64.h"
#else
inline real exp(real x) { return math::exp(x); }
inline real sin(real x) { return math::sin(x); }
inline real cos(real x) { return math::cos(x); }
#endif

// No function of GLSL: log2 of c2 = 1 - s2, where s2 is known without cancellation and may be small.
// resources/shaders/log2_complement.glsl has it for GPUs.
inline real log2_complement(real c2, real s2) {
  return s2 < real(0.5) ? math::log1p(-s2) * real(1.44269504088896340736) : math::log2(max(c2, tiny));
}
#endif
// NOLINTEND
// clang-format on
