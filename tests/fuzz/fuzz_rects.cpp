// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of rectangle lists answers with an Error or with sizes in range, and what
// can be packed is packed without overlap. The first byte picks the form of the pages.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/rects/rects.h"
#include "core/rects/text.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::uint8_t pick = data[0];
  const std::vector<char> bytes(data + 1, data + size);
  try {
    const std::vector<RectSize> sizes = parse_rects({bytes.data(), bytes.size()}, "rects.txt");
    for (const RectSize& r : sizes)
      assert(r.width >= 1 && r.height >= 1 && r.width <= largest_rect_side && r.height <= largest_rect_side);
    // So few, and so few tries, that most of the time goes into new inputs.
    if (sizes.size() > 24) return 0;
    RectOptions options;
    options.form = static_cast<PageForm>(pick % 6);
    options.side = 16 << (pick >> 3 & 7);
    options.rotate = (pick & 64) != 0;
    options.align = (pick & 128) != 0 ? 4 : 1;
    options.effort = 2;
    options.largest_side = largest_rect_side;
    assert(!layout_fault(sizes, pack_rects(sizes, options)));
  } catch (const Error&) {
  }
  return 0;
}
