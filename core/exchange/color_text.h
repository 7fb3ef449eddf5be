// SPDX-License-Identifier: Apache-2.0
#pragma once

// How the numbers of targets are typed; for engine_values.cpp only.

#include <string>

#include "core/base/number.h"
#include "core/color/rgb.h"
#include "core/color/srgb.h"

namespace etak {

inline constexpr int digits = 6;

// A number that no language takes for a whole one.
inline std::string real_text(double value) {
  std::string out = number(value, digits);
  if (out.find_first_of(".en") == out.npos) out += ".0";
  return out;
}

inline std::string three(const LinearRgb& c, const char* between) {
  return real_text(c.r) + between + real_text(c.g) + between + real_text(c.b);
}

inline std::string plain_text(const LinearRgb& c) {
  return number(c.r, digits) + ", " + number(c.g, digits) + ", " + number(c.b, digits);
}

inline std::string glsl_text(const LinearRgb& c) {
  return "vec3(" + three(c, ", ") + ")";
}

inline std::string unreal_text(const LinearRgb& c) {
  return "(R=" + real_text(c.r) + ",G=" + real_text(c.g) + ",B=" + real_text(c.b) + ",A=1.0)";
}

inline std::string blender_text(const LinearRgb& c) {
  return "(" + three(c, ", ") + ", 1.0)";
}

inline std::string vector_text(const LinearRgb& c) {
  return "(" + three(c, ", ") + ")";
}

inline std::string hlsl_text(const LinearRgb& c) {
  return "float3(" + three(c, ", ") + ")";
}

inline std::string c_text(const LinearRgb& c) {
  return "{" + three(c, "f, ") + "f}";
}

// Godot's colours are encoded as sRGB is.
inline std::string godot_text(const LinearRgb& c) {
  return "Color(" + three({srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b)}, ", ") + ")";
}

// Numbers of three.js are linear.
inline std::string threejs_text(const LinearRgb& c) {
  return "new THREE.Color(" + three(c, ", ") + ")";
}

inline std::string hex_text(const LinearRgb& c) {
  return hex(srgb_u8(c));
}

}  // namespace etak
