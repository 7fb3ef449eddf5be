// SPDX-License-Identifier: Apache-2.0
#include "core/image/texture_bytes.h"

#include <algorithm>

namespace etak {

std::uint64_t texture_bytes(const PictureHeader& header, bool mips) {
  const std::uint64_t values = header.channels > 2 ? 4 : static_cast<std::uint64_t>(header.channels);
  std::uint64_t texels = 0;
  for (int width = header.width, height = header.height;;
       width = std::max(1, width / 2), height = std::max(1, height / 2)) {
    texels += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (!mips || (width == 1 && height == 1)) break;
  }
  return texels * values * static_cast<std::uint64_t>(header.bits / 8);
}

}  // namespace etak
