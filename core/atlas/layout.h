// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/atlas/manifest.h"
#include "core/image/atlas_rect.h"
#include "core/image/pixels_view.h"

namespace etak {

struct JsonNode;  // core/base/json/node_json.h

// The table that is written beside the pages of an atlas (resources/schema/atlas-layout.schema.json).

/// What a material needs besides its regions.
struct AtlasMaterialRow {
  std::string name;
  bool texels = true;  // false: the constants are all there is
  AlphaMode alpha_mode = AlphaMode::blend;
  double alpha_cutoff = 0.5;
  std::array<std::optional<std::uint8_t>, channel_count> constant;
  // The value whose code `constant` is, where the atlas was packed from floats; colours in linear light.
  std::array<std::optional<double>, channel_count> value;
  std::vector<std::string> defines;  // for a shader
  std::string layers = {};           // of an F0 that layers on a base make: their text; empty: a bare surface
  friend bool operator==(const AtlasMaterialRow&, const AtlasMaterialRow&) = default;
};

/// One page of an atlas: its size, and the files of its two textures.
struct AtlasPage {
  int width = 0, height = 0;
  std::array<std::vector<std::string>, 2> files;  // by Texture; one per format, then those of mips
  // What red (and green) of specular_gloss hold in its KTX2 and DDS files, where these are in BC4 or BC5: "gloss", or "specular"
  // (of a grey F0, sRGB-encoded, which such a format cannot say) and "gloss". Empty: F0 and gloss as in all other files.
  std::vector<std::string> in_blocks = {};
  // By Texture: its KTX2 and DDS files hold its colour alone, and its fourth channel is red of fourth_file_beside() them.
  std::array<bool, 2> fourth_apart = {};
  // By Texture: its KTX2 and DDS files have the first levels alone, in blocks, and the others are the levels of
  // tail_file_beside() them, as RGBA8.
  std::array<bool, 2> tail_apart = {};
  /// The first file of specular_gloss holds those.
  bool first_in_blocks() const;
  /// The file beside the first one of a texture that holds its fourth channel; empty: the first has four channels.
  std::string fourth_beside_first(Texture texture) const;
  /// The same of the file that holds its last levels; empty: the first has all levels.
  std::string tail_beside_first(Texture texture) const;
  friend bool operator==(const AtlasPage&, const AtlasPage&) = default;
};

/// What an atlas holds and where: the table that is written as layout.json.
struct AtlasLayout {
  GlossForm gloss = GlossForm::schueler;  // what texture B's fourth channel holds
  // Whether the shader is to multiply diffuse by 1 - F, as glTF's does; Schueler's takes it as it is.
  bool diffuse_reduced = false;
  int levels = 1;
  std::vector<AtlasPage> pages;
  std::vector<AtlasRect> rects;             // by name, then island
  std::vector<AtlasMaterialRow> materials;  // by name
  std::string settings_hash, content_hash;
  std::vector<std::string> other_files;  // "scene.gltf", ...
  // 32 hexadecimal digits of XXH3, by the name of the file, of every file but the layout itself as it was written. Layouts of
  // earlier versions have none.
  std::map<std::string, std::string> xxh128;
  friend bool operator==(const AtlasLayout&, const AtlasLayout&) = default;
};

/// The file that holds the fourth channel of a texture alone, "page0_alpha.ktx2" or "page0_gloss.dds", beside a file of
/// page_file(); empty where that is no KTX2 or DDS file of this name.
std::string fourth_file_beside(const std::string& page_file, Texture texture);
/// The same of its last levels: "page0_diffuse_alpha_tail.ktx2".
std::string tail_file_beside(const std::string& page_file, Texture texture);

inline constexpr const char* layout_file_name = "layout.json";

std::string layout_json(const AtlasLayout& layout);

/// A region of a layout that has so many pages. Throws Error with the JSON pointer.
AtlasRect read_layout_rect(const JsonNode& node, std::size_t pages);

/// AtlasPage::in_blocks of a page. Throws Error with the JSON pointer.
std::vector<std::string> read_channels_in_blocks(const JsonNode& page);
/// The same of AtlasPage::fourth_apart.
std::array<bool, 2> read_fourth_apart(const JsonNode& page);
/// And of AtlasPage::tail_apart.
std::array<bool, 2> read_tail_apart(const JsonNode& page);

/// Throws Error with the JSON pointer.
AtlasLayout parse_layout(std::string_view text, std::string_view file);

}  // namespace etak
