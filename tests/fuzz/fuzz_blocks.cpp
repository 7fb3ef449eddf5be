// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes of a level: each format decodes it, with every texel that of its own block. The first three bytes
// are the format and the sides.
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image/blocks/blocks.h"

using namespace etak;

namespace {

// Each texel of a level is that of its own block, which decode() makes of a copy of just its size.
template <class Decode>
void check(const std::vector<char>& bytes, const BlockFormat& format, int width, int height,
           const Decode& decode) {
  const auto level = decode({bytes.data(), bytes.size()}, width, height);
  assert(level.width == width && level.height == height && level.channels == format.channels);
  auto block = bytes.begin();
  for (int top = 0; top < height; top += 4)
    for (int left = 0; left < width; left += 4, block += static_cast<long>(format.block_bytes)) {
      const std::vector<char> own(block, block + static_cast<long>(format.block_bytes));
      const auto alone = decode({own.data(), own.size()}, 4, 4);
      for (int y = top; y < std::min(top + 4, height); ++y)
        for (int x = left; x < std::min(left + 4, width); ++x)
          assert(std::ranges::equal(level.at(x, y), alone.at(x - left, y - top)));
      if (holds_floats(&format))
        for (const float value : alone.values)
          assert(value <= 65504 && (value >= 0 || format.code == BlockCode::bc6h_signed));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const BlockFormat& format = block_formats[data[0] % block_formats.size()];
  if (format.code == BlockCode::astc || format.code == BlockCode::r8)
    return 0;  // no blocks that etak decodes itself
  const int width = 1 + data[1] % 16, height = 1 + data[2] % 16;
  // A copy of just this size: the address sanitizer then sees every read beyond the end.
  std::vector<char> bytes(texture_level_bytes(&format, width, height));
  for (std::size_t i = 0; i < bytes.size() && i + 3 < size; ++i) bytes[i] = static_cast<char>(data[i + 3]);
  if (holds_floats(&format))
    check(bytes, format, width, height, [&format](std::string_view text, int across, int down) {
      return float_level_of(text, format, across, down);
    });
  else
    check(bytes, format, width, height, [&format](std::string_view text, int across, int down) {
      return level_of(text, &format, across, down);
    });
  return 0;
}
