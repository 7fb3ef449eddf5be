// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/pack/decision.h"

namespace etak {

/// Of a level of a page by texel how much of it the triangles of a scene read, 255: all of it. Empty: nothing is known, and all
/// texels of regions count as read.
using TexelsShown = std::vector<std::uint8_t>;

/// The texels of level 0; empty without a scene, and where parts of materials lie apart. Texels that bilinear filtering
/// reads beside a triangle are read.
TexelsShown texels_shown(const PackSource& source, const PackDecision& decision, int page);

/// Of the next level, by those of one that has width x height texels. What is read at all is 1 at least.
TexelsShown next_level(const TexelsShown& of, int width, int height);

}  // namespace etak
