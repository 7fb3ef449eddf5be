// SPDX-License-Identifier: Apache-2.0
#include "core/base/shards/shards.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "core/base/random.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ShardOutput output_of(const std::string& file, Shard shard, const std::string& content = "c") {
  return {file, shard, "1.0", "options", "list", content, 0};
}

}  // namespace

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

TEST_CASE("the outputs of a run are put into order; equal doubles count once") {
  const std::vector<ShardOutput> outputs{output_of("c", {3, 3}), output_of("a", {1, 3}),
                                         output_of("b", {2, 3}), output_of("a again", {1, 3})};
  CHECK(complete_shards(outputs, "1.0") == std::vector<std::size_t>{1, 2, 0});
}

TEST_CASE("missing, foreign, mixed and differing shards are named") {
  const auto why = [](std::vector<ShardOutput> outputs) {
    return error_of([&] { complete_shards(outputs, "1.0"); });
  };
  const ShardOutput one = output_of("a", {1, 4}), two = output_of("b", {2, 4});
  CHECK(contains(why({one, two}), "missing: shards 3/4, 4/4"));
  CHECK(contains(why({one, two, output_of("d", {4, 4})}), "missing: shard 3/4"));
  CHECK(contains(why({one, output_of("x", {2, 5})}), "x: is shard 2/5"));
  CHECK(contains(why({one, output_of("x", {1, 4}, "other")}),
                 "x: is shard 1/4 like a, and their bytes differ"));
  ShardOutput foreign = two;
  foreign.list = "other";
  CHECK(contains(why({one, foreign}), "b: was cut from another list of inputs than a"));
  foreign = two;
  foreign.options = "other";
  CHECK(contains(why({one, foreign}), "b: was run with other options than a"));
  foreign = two;
  foreign.version = "0.9";
  CHECK(contains(why({one, foreign}), "b: was written by etak 0.9; expected all shards of etak 1.0"));
  ShardOutput first = output_of("a", {1, 2, std::pair<std::size_t, std::size_t>(0, 3)});
  ShardOutput second = output_of("b", {2, 2, std::pair<std::size_t, std::size_t>(3, 5)});
  first.items = second.items = 5;
  CHECK(why({first, second}).empty());
  second.shard.items = {4, 5};
  CHECK(contains(why({first, second}), "b: holds other items than follow those of the shards before it"));
  second.shard.items = {3, 4};
  CHECK(contains(why({first, second}), "b: holds other items"));
  const std::string many = why({output_of("a", {1, 1000})});
  CHECK(contains(many, "and 979 more"));
}
