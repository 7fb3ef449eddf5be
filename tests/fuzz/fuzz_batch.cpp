// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of job files (etak pack --batch) answers with an Error or with jobs that say
// what is packed and where to.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/pack/settings.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  std::vector<PackSettings> jobs;
  std::vector<std::string> remarks;
  try {
    jobs = parse_pack_jobs({bytes.data(), bytes.size()}, "folder/jobs.json", {}, remarks);
  } catch (const Error&) {
    return 0;
  }
  assert(!jobs.empty());
  for (const PackSettings& job : jobs) {
    assert(!job.input.empty() && !job.out.empty());
    assert(job.page >= 1 && job.page <= 16384 && job.effort >= 1 && job.zstd >= 0 && job.zstd <= 22);
  }
  return 0;
}
