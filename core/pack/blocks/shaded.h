// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/pack/blocks/compress_page.h"

namespace etak {

/// Puts into the reports of a page's textures what their blocks change of its materials under light: texels of level 0
/// are shaded once as they are and once as the blocks hold them.
///   - Of each material the texels that it reads, at most most_shaded_texels, evenly along the blocks that it owns.
///   - Lambert and Schueler's bounded Optimized, under the three lights of default_lights() together, without the
///     hemispheres, seen 0, 20, 40, 60 and 75 degrees from the normal, away from the key light, where 54 is its mirror
///     direction. Light above 1 is white. What lets light through is over black.
///   - The mean of FLIP is of the part, at most most_shaded_side texels a side, in which these differ most, seen from that
///     direction from which they do, with a pixel a texel at FLIP's usual distance.
///   - A channel that is one number of the material is that number in both; what is on another page is as by `elsewhere`.
///   - A picture is of a part that is chosen the same way, of twice the side.
///   job       of either texture
///   made      by Texture; those that stay RGBA8 are exact
inline constexpr std::size_t most_shaded_texels = 1024;
inline constexpr std::size_t most_shaded_side = 64;
inline constexpr std::array<std::uint8_t, channel_count> elsewhere{128, 128, 128, 255, 56, 56, 56, 128};
///   most      pictures that are kept of all pages
///   pictures  of the materials that differ most, at the 99th percentile; gets those of this page
void tell_shaded(const BlockJob& job, std::array<CompressedTexture, 2>& made, std::size_t most,
                 std::vector<BlockPicture>& pictures);

}  // namespace etak
