// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/image/image.h"

namespace etak {

/// Pictures of one size in a grid with labels: columns named above, rows at the left, grey between.
struct Sheet {
  std::vector<std::string> columns, rows;
  std::vector<Image> pictures;  // three or four channels, row after row; an empty one leaves its place grey
};

/// The sheet as one picture of three channels in linear light.
Image laid_out(const Sheet& sheet);

}  // namespace etak
