// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/atlas/texels/compose.h"
#include "core/base/files/output_folder.h"

namespace etak {

/// One page as floats, by Texture and level: colours in linear light, alpha and gloss as they are. Empty
/// where the page has no such texture.
struct FloatPage {
  std::array<std::vector<Image>, 2> levels;

  /// A texture's level; its data is null where the page has no such texture.
  PixelsViewOf<float> view(Texture texture, int level);
};

/// A page of floats from the numbers of the files, with the places, gutters and mips that Composer gives pages of 8 bits.
FloatPage compose_floats(int page, int levels, const std::vector<PackInput>& materials,
                         const std::vector<Region>& regions, const PackingPlan& plan,
                         const ComposeOptions& options);

/// Writes the page's files of one format.
void write_float_page(OutputFolder& folder, int page, const FloatPage& pixels, const std::string& format,
                      const PictureDoor& door);

}  // namespace etak
