// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/image/channels.h"
#include "core/image/pixels_view.h"

namespace etak {

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
  // Whether the material reads each ChannelPart here. The other parts lie in other regions of it.
  std::array<bool, channel_parts.size()> holds{true, true, true, true};

  bool holds_channel(std::size_t channel) const {
    return holds[2 * (channel / 4) + (channel % 4 == 3 ? 1 : 0)];
  }
  bool holds_all() const { return holds == std::array{true, true, true, true}; }
  friend bool operator==(const AtlasRect&, const AtlasRect&) = default;
};

}  // namespace etak
