// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes of a level: each format decodes it, with every texel that of its own block. The first three bytes
// are the format and the sides.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image/blocks/blocks.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const BlockFormat& format = block_formats[data[0] % block_formats.size()];
  if (format.code == BlockCode::astc) return 0;  // not decoded by etak itself
  const int width = 1 + data[1] % 16, height = 1 + data[2] % 16;
  // A copy of just this size: the address sanitizer then sees every read beyond the end.
  std::vector<char> bytes(texture_level_bytes(&format, width, height));
  for (std::size_t i = 0; i < bytes.size() && i + 3 < size; ++i) bytes[i] = static_cast<char>(data[i + 3]);
  const Image8 level = level_of({bytes.data(), bytes.size()}, &format, width, height);
  assert(level.width == width && level.height == height);
  const auto across = static_cast<std::size_t>(width + 3) / 4;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t block = static_cast<std::size_t>(y / 4) * across + static_cast<std::size_t>(x / 4);
      const std::vector<std::uint8_t> alone(
          bytes.begin() + static_cast<long>(block * format.block_bytes),
          bytes.begin() + static_cast<long>((block + 1) * format.block_bytes));
      const auto texel =
          decode_block(format.code, alone.data())[static_cast<std::size_t>(4 * (y % 4) + x % 4)];
      for (std::size_t c = 0; c < level.at(x, y).size(); ++c) assert(level.at(x, y)[c] == texel[c]);
    }
  return 0;
}
