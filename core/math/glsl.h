// SPDX-License-Identifier: Apache-2.0
// No include guard: this file gives a namespace the part of GLSL that etak's formula texts (*.glsl) use. Include it
// inside a namespace where `real` is a type; the names there hide the standard ones.
// NOLINTBEGIN
inline real abs(real x) { return x < 0 ? -x : x; }
inline real min(real a, real b) { return b < a ? b : a; }
inline real max(real a, real b) { return a < b ? b : a; }
inline real clamp(real x, real lo, real hi) { return min(max(x, lo), hi); }
inline real mix(real a, real b, real t) { return a * (1 - t) + b * t; }
inline real sqrt(real x) { return std::sqrt(x); }
inline real pow(real x, real e) { return std::pow(x, e); }
inline real exp2(real x) { return std::exp2(x); }
// NOLINTEND
