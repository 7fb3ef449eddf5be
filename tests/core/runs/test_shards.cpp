// SPDX-License-Identifier: Apache-2.0
#include "core/runs/shards.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "core/base/random.h"

using namespace etak;

TEST_CASE("a shard is named by two numbers and nothing else") {
  CHECK(shard_named("2/4") == Shard{2, 4});
  CHECK(shard_named("1/1") == Shard{1, 1});
  CHECK(shard_named("2/4:25-50") == Shard{2, 4, std::pair<std::size_t, std::size_t>(25, 50)});
  for (const char* text : {"",          "2",     "/",      "0/4",
                           "5/4",       "2/",    "/4",     "-1/4",
                           "2/4/",      " 2/4",  "2/4 ",   "a/b",
                           "1/1000001", "2.0/4", "+1/4",   "99999999999999999999/99999999999999999999",
                           "2/4:",      "2/4:5", "2/4:5-", "2/4:6-5",
                           "2/4:a-b"}) {
    INFO(text);
    CHECK(!shard_named(text));
  }
}

TEST_CASE("shards hold every item once, in order, and about the same number of bytes") {
  SplitMix random(3);
  for (int run = 0; run < 300; ++run) {
    std::vector<std::uint64_t> bytes(random.next() % 60);
    std::uint64_t most = 0;
    for (std::uint64_t& size : bytes) {
      size = random.next() % (random.next() % 2 == 0 ? 1000 : 5000000);
      most = std::max(most, size + 16384);
    }
    const std::uint64_t all =
        std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{16384 * bytes.size()});
    const std::size_t count = 1 + random.next() % 9;
    std::size_t next = 0;
    for (std::size_t index = 1; index <= count; ++index) {
      const auto [first, last] = items_of({index, count}, bytes);
      REQUIRE(first <= last);
      if (first < last) {
        CHECK(first == next);
        next = last;
      }
      std::uint64_t own = 0;
      for (std::size_t i = first; i < last; ++i) own += bytes[i] + 16384;
      // No cut is further from its place than half of an item.
      CHECK(own <= all / count + most + 1);
    }
    CHECK(next == bytes.size());
  }
}

TEST_CASE("more shards than items leave some empty, and sums of petabytes do not overflow") {
  const std::vector<std::uint64_t> three(3, 100);
  std::size_t items = 0;
  for (std::size_t i = 1; i <= 7; ++i) {
    const auto [first, last] = items_of({i, 7}, three);
    items += last - first;
  }
  CHECK(items == 3);
  CHECK(items_of({2, 3, std::pair<std::size_t, std::size_t>(1, 2)}, three) ==
        std::pair<std::size_t, std::size_t>(1, 2));
  CHECK(items_of({1, 3}, {}) == std::pair<std::size_t, std::size_t>(0, 0));
  const std::vector<std::uint64_t> large(1000, std::uint64_t{1} << 50);
  const auto [first, last] = items_of({500000, 1000000}, large);
  CHECK(last - first <= 1);
  const auto [from, to] = items_of({2, 4}, large);
  CHECK(from == 250);
  CHECK(to == 500);
}
