// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace etak {

/// How a folder of earlier results is used.
///   path         the folder, made where it is missing
///   kind         one word for what the entries hold: entries of another kind do not count
///   key          the bytes of a secret; empty: none
///   most_bytes   that all entries may take
///   counted      use() counts what is in the folder
struct CacheOptions {
  std::string path, kind, key;
  std::uint64_t most_bytes = std::uint64_t{2} << 30;
  bool counted = false;
};

/// What a run did with its cache. Every look-up is a hit or a miss.
///   refused       entries that were there, but damaged, foreign, or sealed with another key: misses
///   too_large     results that were not kept, because one entry may take a quarter of the cache at most
///   not_written   results that were not kept, because the folder takes nothing
///   evicted       entries that this run has removed to keep the cache within its size
struct CacheCounts {
  std::uint64_t hits = 0, misses = 0, refused = 0, written = 0, too_large = 0, not_written = 0, evicted = 0;
  friend bool operator==(const CacheCounts&, const CacheCounts&) = default;
};

/// The entries that are in the folder now, of all kinds. Each counts in blocks of 4 KiB, as disks hold it.
struct CacheSize {
  std::uint64_t entries = 0, bytes = 0;
};

/// What a run did with its cache, and what is there at its end.
///   size      none where nobody asked for it
///   fault     why nothing is kept any more; empty where all is well
///   missing   there is no folder, and none could be made
struct CacheUse {
  CacheCounts counts;
  std::optional<CacheSize> size;
  std::string fault;
  bool missing = false;
};

/// The numbers as one line of text, and as JSON (resources/schema/cache.schema.json).
std::string cache_text(const CacheUse& use);
std::string cache_json(const CacheUse& use);

}  // namespace etak
