// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/validate/target.h"

namespace etak {

/// Rows of a texture that an atlas does without: every tile, and the gutter around it, in its flat codes, the
/// rest hidden (alpha 0 in the diffuse texture). What was left out of the pictures is judged like what is in
/// them.
///   texture         0 diffuse, 1 specular
///   width, height   of the page; 0: just what the tiles reach
/// Null when some tile has no codes for it.
std::unique_ptr<RowSource> flat_rows(const CheckTarget& target, std::size_t texture, int width, int height);

/// Tiles for materials that are on no page at all: places of their own, in rows.
void place_flat_tiles(Manifest& manifest);

/// Takes those places out of a finding, which is about numbers.
void forget_place(Finding& finding);

}  // namespace etak
