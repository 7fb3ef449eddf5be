// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the material reader answers with an Error or with a material that survives being
// written and read again.
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"
#include "core/material/json.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  Material material;
  try {
    material = parse_material({bytes.data(), bytes.size()}, "material.json");
  } catch (const Error&) {
    return 0;
  }
  assert(!material.datasets.empty() && material.preferred < material.datasets.size());
  assert(parse_material(format_material(material), "written") == material);
  return 0;
}
