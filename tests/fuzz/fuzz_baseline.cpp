// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of baselines answers with an Error or with defects that are written and read
// again unchanged.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/findings/baseline.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  std::vector<KnownDefect> known;
  try {
    known = read_baseline({bytes.data(), bytes.size()}, "baseline.json");
  } catch (const Error&) {
    return 0;
  }
  assert(read_baseline(baseline_json(known), "written") == known);
  // A report without findings has nothing to mark, whatever is known.
  ValidationReport report;
  mark_known(report, known);
  return 0;
}
