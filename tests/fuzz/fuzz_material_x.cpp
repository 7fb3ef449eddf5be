// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of a MaterialX document answers with an Error of one line or with surfaces whose numbers are finite, and
// what they come to can be computed.
#include "tests/fuzz/surfaces.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return etak::test::read_surfaces(
      data, size, [](auto text, const auto& file) { return etak::surfaces_of_material_x(text, file); });
}
