// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace etak {

/// What a row is about that is not a reflectance model.
enum class LightRowKind { light, hemispheres, environment, tone, transfer, transparency };
std::string_view name(LightRowKind kind);

/// A choice of light, transfer or transparency as the sources name it: the rest of the registry, for lists
/// and editors.
struct LightRow {
  std::string_view id;  // "hemispheres-specular-wide"
  std::string_view title;
  std::string_view source;
  LightRowKind kind;
  std::string_view parameters;  // with units, for reading: "intensity (W/sr), position"
  std::string_view file;        // GLSL text, "light/hemispheres.glsl"; empty: none of its own
  std::string_view entry;       // its function there
  std::string_view note;        // what it claims, "rms error of the share 0.013 at g = 1"
  bool is_default = false;      // of the rows of its kind that exclude each other
};
std::span<const LightRow> light_rows();

}  // namespace etak
