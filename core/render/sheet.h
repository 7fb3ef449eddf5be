// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/image/image.h"

namespace etak {

/// Pictures of one size in a grid, with the labels of the columns above, those of the rows on the left, and
/// grey between the pictures.
struct Sheet {
  std::vector<std::string> columns, rows;
  std::vector<Image> pictures;  // three or four channels, row by row; an empty one leaves its place grey
};

/// Draws the sheet as one picture of three channels in linear light.
Image laid_out(const Sheet& sheet);

}  // namespace etak
