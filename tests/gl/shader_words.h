// SPDX-License-Identifier: Apache-2.0
// The words of HLSL and of the Metal Shading Language that etak's formula texts use, as C++: the texts of
// `etak shader --language hlsl` and `msl` can be compiled with them and run. Not a language's whole library.
#pragma once

#include <cmath>

namespace shader_words {

struct float3 {
  float x, y, z;
  float3() : x(0), y(0), z(0) {}
  explicit float3(float all) : x(all), y(all), z(all) {}
  float3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
};
inline float3 operator+(float3 a, float3 b) {
  return float3(a.x + b.x, a.y + b.y, a.z + b.z);
}
inline float3 operator-(float3 a, float3 b) {
  return float3(a.x - b.x, a.y - b.y, a.z - b.z);
}
inline float3 operator*(float3 a, float3 b) {
  return float3(a.x * b.x, a.y * b.y, a.z * b.z);
}
inline float3 operator*(float3 a, float s) {
  return float3(a.x * s, a.y * s, a.z * s);
}
inline float3 operator*(float s, float3 a) {
  return a * s;
}
inline float3 operator/(float3 a, float s) {
  return float3(a.x / s, a.y / s, a.z / s);
}
inline float dot(float3 a, float3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline float min(float a, float b) {
  return b < a ? b : a;
}
inline float max(float a, float b) {
  return a < b ? b : a;
}
inline float clamp(float x, float low, float high) {
  return min(max(x, low), high);
}
inline float abs(float x) {
  return std::fabs(x);
}
inline float sqrt(float x) {
  return std::sqrt(x);
}
inline float rsqrt(float x) {
  return 1 / std::sqrt(x);
}
inline float pow(float x, float e) {
  return std::pow(x, e);
}
inline float exp(float x) {
  return std::exp(x);
}
inline float exp2(float x) {
  return std::exp2(x);
}
inline float log(float x) {
  return std::log(x);
}
inline float log2(float x) {
  return std::log2(x);
}
inline float mix(float a, float b, float t) {
  return a + (b - a) * t;
}
inline float3 mix(float3 a, float3 b, float t) {
  return a + (b - a) * t;
}
inline float lerp(float a, float b, float t) {
  return mix(a, b, t);
}
inline float3 lerp(float3 a, float3 b, float t) {
  return mix(a, b, t);
}

}  // namespace shader_words

namespace metal {
using namespace shader_words;
}  // namespace metal

#define constant static const
