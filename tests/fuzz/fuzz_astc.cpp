// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes of a level: ASTC is decoded, with every texel that of its own block. The first three bytes are the
// format and the sides. Astcenc itself is not instrumented; what is looked for is where it reads or writes beyond memory,
// and what etak expects of it.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/image/astc_codec.h"
#include "core/image/blocks/blocks.h"

using namespace etak;

namespace {

std::vector<const BlockFormat*> astc_formats() {
  std::vector<const BlockFormat*> out;
  for (const BlockFormat& each : block_formats)
    if (each.code == BlockCode::astc) out.push_back(&each);
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<const BlockFormat*> formats = astc_formats();
  static const AstcDoor door = astc_door();
  if (size < 3) return 0;
  const BlockFormat& format = *formats[data[0] % formats.size()];
  const AstcEncoding how{&format, data[0] >= 128};
  const int width = 1 + data[1] % 24, height = 1 + data[2] % 24;
  // A copy of just this size: the address sanitizer then sees every read beyond the end.
  std::vector<char> bytes(texture_level_bytes(&format, width, height));
  for (std::size_t i = 0; i < bytes.size() && i + 3 < size; ++i) bytes[i] = static_cast<char>(data[i + 3]);
  const Image8 level = door.decode({bytes.data(), bytes.size()}, how, width, height, "level");
  assert(level.width == width && level.height == height && level.channels == 4);
  const int across = (width + format.block_width - 1) / format.block_width;
  for (int y = 0; y < height; y += format.block_height)
    for (int x = 0; x < width; x += format.block_width) {
      const auto block = static_cast<std::size_t>(y / format.block_height * across + x / format.block_width);
      const std::vector<char> own(bytes.begin() + static_cast<long>(block * format.block_bytes),
                                  bytes.begin() + static_cast<long>((block + 1) * format.block_bytes));
      const Image8 alone =
          door.decode({own.data(), own.size()}, how, format.block_width, format.block_height, "block");
      for (int v = 0; v < format.block_height && y + v < height; ++v)
        for (int u = 0; u < format.block_width && x + u < width; ++u)
          for (std::size_t c = 0; c < 4; ++c) assert(level.at(x + u, y + v)[c] == alone.at(u, v)[c]);
    }
  return 0;
}
