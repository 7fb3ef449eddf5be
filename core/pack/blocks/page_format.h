// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/atlas/layout.h"
#include "core/pack/blocks/compress_options.h"
#include "core/pack/decision.h"

namespace etak {

/// What is left out of F0 and gloss by the materials of a page decides which blocks hold the rest.
///   returns   BC4 (gloss alone) where F0 is constant in each of them, BC5 (F0 and gloss) where it is grey or constant,
///             else null
const BlockFormat* fitting_format(const PackDecision& decision, int page);

/// Whether a format is one of these, whose channels are compressed apart.
constexpr bool is_fitting(const BlockFormat& format) {
  return format.code == BlockCode::bc4 || format.code == BlockCode::bc5;
}

/// Whether a material needs no texture for F0.
bool has_constant_f0(const MaterialFate& fate);

/// Whether some material of a page reads the fourth channel of one of its textures.
bool reads_fourth(const PackDecision& decision, const std::vector<PackInput>& materials, int page,
                  Texture texture);

/// Puts into the layout which channels textures in BC4 and BC5 hold, which fourth channels lie apart with their files, and the
/// defines for their shaders.
///   formats   of the files
void tell_channels(const std::vector<BlockLevel>& levels, const std::vector<std::string>& formats,
                   AtlasLayout& layout);

}  // namespace etak
