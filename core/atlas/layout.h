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
#include "core/image/channels.h"
#include "core/image/pixels_view.h"

namespace etak {

struct JsonNode;  // core/base/json/node_json.h

// The table that is written beside the pages of an atlas (resources/schema/atlas-layout.schema.json).

/// The parts of a texel of the pair that may lie at places of their own, as --goal one-page lays them.
///   first, size   the channels of the part
struct ChannelPart {
  std::string_view name;
  std::size_t first, size;
};
inline constexpr std::array<ChannelPart, 4> channel_parts{{{"diffuse", 0, 3},
                                                           {"alpha", alpha_channel, 1},
                                                           {"specular", specular_channel, 3},
                                                           {"gloss", gloss_channel, 1}}};

/// A region of a material. Materials that share texels have a row each.
struct AtlasRect {
  std::string name;  // of the material
  int island = 0;    // 0 but for materials in several parts
  int page = 0;
  int x = 0, y = 0, width = 0, height = 0;  // level-0 texels on the page, without gutter
  bool rotated = false;  // by 90 degrees: column c of the picture is row c, rows run from right to left
  PixelBox crop;         // the part of the picture that the region shows, in texels
  int source_width = 0, source_height = 0;  // of the whole picture
  int gutter = 0, mips = 1;                 // mips free of neighbours
  double inset = 0;      // where there is no gutter: level-0 texels that UVs must stay inside the region
  bool repeats = false;  // the page holds this region alone, and its sampler wraps
  bool source_gutter = false;  // the gutter holds what the picture has there, not the region's edge again
  // By ChannelPart: what the material reads here. The other parts lie in other regions of it.
  std::array<bool, channel_parts.size()> holds{true, true, true, true};

  bool holds_channel(std::size_t channel) const {
    return holds[2 * (channel / 4) + (channel % 4 == 3 ? 1 : 0)];
  }
  bool holds_all() const { return holds == std::array{true, true, true, true}; }
  friend bool operator==(const AtlasRect&, const AtlasRect&) = default;
};

/// What a material needs besides its regions.
struct AtlasMaterialRow {
  std::string name;
  bool texels = true;  // false: the constants are all there is
  AlphaMode alpha_mode = AlphaMode::blend;
  double alpha_cutoff = 0.5;
  std::array<std::optional<std::uint8_t>, channel_count> constant;
  // Of the same channels where the atlas was packed from floats: what `constant` is the code of, colours in
  // linear light.
  std::array<std::optional<double>, channel_count> value;
  std::vector<std::string> defines;  // for a shader
  friend bool operator==(const AtlasMaterialRow&, const AtlasMaterialRow&) = default;
};

/// One page of an atlas: its size, and the files of its two textures.
struct AtlasPage {
  int width = 0, height = 0;
  std::array<std::vector<std::string>, 2> files;  // by Texture; one per format, then those of mips
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
  // Of every file but the layout itself as it was written: 32 hexadecimal digits of XXH3 by name. Layouts of earlier versions
  // have none.
  std::map<std::string, std::string> xxh128;
  friend bool operator==(const AtlasLayout&, const AtlasLayout&) = default;
};

inline constexpr const char* layout_file_name = "layout.json";

std::string layout_json(const AtlasLayout& layout);

/// A region of a layout that has so many pages. Throws Error with the JSON pointer.
AtlasRect read_layout_rect(const JsonNode& node, std::size_t pages);

/// Throws Error with the JSON pointer.
AtlasLayout parse_layout(std::string_view text, std::string_view file);

}  // namespace etak
