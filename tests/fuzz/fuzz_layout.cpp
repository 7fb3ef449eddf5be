// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of an atlas's table answers with an Error or with a layout that is written
// and read again unchanged.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/atlas/layout.h"
#include "core/base/error.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  AtlasLayout layout;
  try {
    layout = parse_layout({bytes.data(), bytes.size()}, "layout.json");
  } catch (const Error&) {
    return 0;
  }
  assert(parse_layout(layout_json(layout), "written") == layout);
  return 0;
}
