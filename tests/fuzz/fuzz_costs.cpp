// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of cost tables answers with an Error or with times above 0, which are
// written and read again; rounded once, they stay.
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/study/choose/choose.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  CostTable costs;
  try {
    costs = parse_costs({bytes.data(), bytes.size()}, "costs.json");
  } catch (const Error&) {
    return 0;
  }
  for (const auto& [id, ns] : costs.ns) assert(ns > 0 && std::isfinite(ns));
  const std::string rounded = format_costs(parse_costs(format_costs(costs), "written"));
  assert(rounded == format_costs(costs));
  return 0;
}
