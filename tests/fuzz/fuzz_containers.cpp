// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the KTX2 and DDS readers answer with an Error or with levels, which are written and read
// again unchanged where they are RGBA8. The first byte picks the reader.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "tests/core/image/container_bytes.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  // A copy of just this size: the address sanitizer then sees every read beyond the end.
  const std::vector<char> bytes(data + 1, data + size);
  const std::string_view text(bytes.data(), bytes.size());
  const bool ktx2 = (data[0] & 1) != 0;
  TextureFile file;
  try {
    file = ktx2 ? read_ktx2(text, "file") : read_dds(text, "file");
  } catch (const Error&) {
    return 0;
  }
  assert(holds_floats(file.blocks) ? !file.floats.empty() : !file.levels.empty());
  if (file.blocks != nullptr) {
    for (const Image8& level : file.levels) assert(level.channels == file.blocks->channels);
    return 0;
  }
  const test::TextureLevels levels{file.levels, file.srgb};
  const TextureFile again = ktx2 ? read_ktx2(test::ktx2_bytes(levels, 0), "again")
                                 : read_dds(test::dds_bytes(levels, file.custom_alpha), "again");
  assert(again.levels == file.levels && again.srgb == file.srgb && again.custom_alpha == file.custom_alpha);
  return 0;
}
