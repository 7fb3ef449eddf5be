// SPDX-License-Identifier: Apache-2.0
// What tests of a cache's folder share.
#pragma once

#include <cstdint>
#include <string>

#include "core/runs/cache_folder.h"

namespace etak::test {

/// A cache of the kind "test" in a folder, which tells its size.
///   most   bytes that it may take
inline CacheOptions cache_at(const std::string& path, std::uint64_t most = std::uint64_t{1} << 30) {
  CacheOptions out;
  out.path = path;
  out.kind = "test";
  out.most_bytes = most;
  out.counted = true;
  return out;
}

}  // namespace etak::test
