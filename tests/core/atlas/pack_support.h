// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/pack/pack.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "tests/support.h"

/// What the tests of `etak pack` share.
namespace etak::test {

inline const MaterialLibrary& built_in_library() {
  static const MaterialLibrary built_in = MaterialLibrary::builtin();
  return built_in;
}

inline Image8 noise(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  Image8 out(width, height, channels);
  for (auto& each : out.values) each = static_cast<std::uint8_t>(random());
  return out;
}

inline void save_png(const std::string& path, const Image8& image) {
  const PngRows rows{{image.width, image.height, image.channels, 8},
                     image.values.data(),
                     static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels)};
  spit(path, png_bytes(rows, {}));
}

inline Image8 load_png(const std::string& path) {
  auto image = read_png8(slurp(path), path);
  REQUIRE(image);
  return *image;
}

inline PackReport pack_text(const TempFolder& folder, const std::string& manifest,
                            const PackOptions& options) {
  spit(folder.file("m.json"), manifest);
  return pack(folder.file("m.json"), folder.file("out"), options, built_in_library());
}

inline AtlasLayout packed_layout(const TempFolder& folder) {
  return parse_layout(slurp(folder.file("out/layout.json")), "layout.json");
}

inline const AtlasRect& rect_named(const AtlasLayout& layout, const std::string& name) {
  for (const AtlasRect& rect : layout.rects)
    if (rect.name == name) return rect;
  FAIL("no region of " << name);
  throw;
}

inline const AtlasMaterialRow& row_named(const AtlasLayout& layout, const std::string& name) {
  for (const AtlasMaterialRow& row : layout.materials)
    if (row.name == name) return row;
  FAIL("no material " << name);
  throw;
}

inline const LeaveOutLine* line_named(const PackReport& report, const std::string& what) {
  for (const LeaveOutLine& line : report.left_out.lines)
    if (line.what == what) return &line;
  return nullptr;
}

}  // namespace etak::test
