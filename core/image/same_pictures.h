// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/image/picture.h"

namespace etak {

/// For each picture the first one that is the same, which may be itself: of the same bytes or, of PNG files that can be
/// read row by row, of the same header and the same texels (other programs or levels of compression make other bytes).
///   used   pictures that count; the others stand for themselves
/// Throws Error for a picture file that cannot be read.
std::vector<int> first_of_same_pictures(std::span<const PictureFile> pictures, const std::vector<bool>& used);

}  // namespace etak
