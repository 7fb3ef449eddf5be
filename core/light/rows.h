// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace etak {

/// The subject of a registry row that is not about a reflectance model.
enum class LightRowKind { light, hemispheres, environment, tone, transfer, transparency };
std::string_view name(LightRowKind kind);

/// A kind of light, transfer curve or transparency, named as in its source. These rows are the part of the
/// registry besides the reflectance models; lists and editors show them.
struct LightRow {
  std::string_view id;  // "hemispheres-specular-wide"
  std::string_view title;
  std::string_view source;
  LightRowKind kind;
  std::string_view parameters;  // with units, as a text: "intensity (W/sr), position"
  std::string_view file;        // the GLSL text, "light/hemispheres.glsl"; empty: it has none
  std::string_view entry;       // the function in that text
  std::string_view note;        // its properties: "rms error of the share 0.065 at g = 0.75"
  bool is_default = false;      // the default among rows of its kind that exclude each other
};
std::span<const LightRow> light_rows();

}  // namespace etak
