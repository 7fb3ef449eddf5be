// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "core/pack/pack.h"
#include "tests/core/image/png_of.h"
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
  spit(path, png_bytes(image, {}));
}

inline Image8 load_png(const std::string& path) {
  auto image = read_png8(slurp(path), path);
  REQUIRE(image);
  return *image;
}

inline PackResult pack_text(const TempFolder& folder, const std::string& manifest,
                            const PackOptions& options = {}) {
  spit(folder.file("m.json"), manifest);
  return pack(folder.file("m.json"), folder.file("out"), options, built_in_library());
}

/// The message of the Error that packing ends with; "" where it ends well.
inline std::string packing_fault(const TempFolder& folder, const std::string& manifest,
                                 const PackOptions& options = {}) {
  return error_of([&] { (void)pack_text(folder, manifest, options); });
}

/// Four pictures of noise in the folder: diffuse, specular, gloss and alpha of the material `name`.
inline void add_noise_material(const TempFolder& folder, const std::string& name, int width, int height,
                               unsigned seed) {
  save_png(folder.file(name + "_diffuse.png"), noise(width, height, 3, seed));
  save_png(folder.file(name + "_specular.png"), noise(width, height, 3, seed + 1));
  save_png(folder.file(name + "_gloss.png"), noise(width, height, 1, seed + 2));
  save_png(folder.file(name + "_alpha.png"), noise(width, height, 1, seed + 3));
}

/// The material of add_noise_material() as a manifest has it.
inline std::string manifest_entry(const std::string& name) {
  std::string out = "{\"name\": \"" + name + "\"";
  for (const char* role : {"diffuse", "specular", "gloss", "alpha"})
    out += std::string(", \"") + role + "\": \"" + name + "_" + role + ".png\"";
  return out + "}";
}

inline std::string manifest_of(const std::vector<std::string>& entries) {
  std::string out = "{\"materials\": [";
  for (std::size_t i = 0; i < entries.size(); ++i) out += (i == 0 ? "" : ", ") + entries[i];
  return out + "]}";
}

/// Texel (x, y) of a material's picture in the page texture.
inline const std::uint8_t* texel_of(const Image8& page, const AtlasRect& rect, int x, int y) {
  if (rect.rotated) return page.at(rect.x + rect.width - 1 - y, rect.y + x).data();
  return page.at(rect.x + x, rect.y + y).data();
}

/// Names of the files in a folder, sorted.
inline std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> out;
  for (const auto& each : std::filesystem::directory_iterator(folder))
    out.push_back(each.path().filename().string());
  std::sort(out.begin(), out.end());
  return out;
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

inline const LeaveOutLine* line_named(const PackResult& report, const std::string& what) {
  for (const LeaveOutLine& line : report.left_out.lines)
    if (line.what == what) return &line;
  return nullptr;
}

}  // namespace etak::test
