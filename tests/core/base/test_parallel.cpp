// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("every index is visited exactly once, for any count, chunk and number of threads") {
  for (const std::size_t count : {0, 1, 7, 64, 1000})
    for (const unsigned threads : {1u, 2u, 8u})
      for (const std::size_t chunk : {1, 16, 5000}) {
        std::vector<int> visits(count, 0);
        std::atomic<bool> in_range{true};
        parallel_chunks(count, threads, chunk, [&](std::size_t begin, std::size_t end, unsigned worker) {
          if (begin >= end || end > count || end - begin > chunk || worker >= threads) in_range = false;
          for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        INFO(count << " by " << chunk << " on " << threads);
        CHECK(in_range);
        CHECK(visits == std::vector<int>(count, 1));
      }
}

TEST_CASE("an exception of any worker reaches the caller after all have stopped") {
  std::atomic<int> running{0};
  const auto message = error_of([&] {
    parallel_chunks(1000, 4, 1, [&](std::size_t begin, std::size_t, unsigned) {
      ++running;
      if (begin == 100) {
        --running;
        throw Error::at("page 100", "broken");
      }
      --running;
    });
  });
  CHECK(message == "page 100: broken");
  CHECK(running == 0);
}
