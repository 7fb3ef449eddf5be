// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of a result in a cache, whose seal anybody can make without a key, answers with
// nothing or with a result that is written and read again unchanged.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/validate/files/result_text.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  const std::optional<CheckedFile> file = read_result_text({bytes.data(), bytes.size()});
  if (!file) return 0;
  const std::string written = result_text(*file);
  const std::optional<CheckedFile> again = read_result_text(written);
  assert(again && result_text(*again) == written);
  return 0;
}
