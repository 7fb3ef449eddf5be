// SPDX-License-Identifier: Apache-2.0
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("no number of threads means all cores, and 256 are the most") {
  CHECK(thread_count(0) >= 1);
  CHECK(thread_count(1) == 1);
  CHECK(thread_count(7) == 7);
  CHECK(thread_count(100000) == 256);
}

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

TEST_CASE("without threads the caller does the work alone") {
  // In a process of its own, since the limit stays. A stack of more than the address space cannot be had.
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, std::size_t{1} << 46);
    ::pthread_setattr_default_np(&attributes);
    std::vector<std::thread> threads;
    if (start_thread(threads, [] {})) ::_exit(2);
    std::size_t visited = 0;
    parallel_chunks(1000, 8, 10,
                    [&](std::size_t begin, std::size_t end, unsigned) { visited += end - begin; });
    ::_exit(visited == 1000 ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
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

TEST_CASE("of several exceptions that of the first chunk reaches the caller, whichever came first") {
  for (int run = 0; run < 20; ++run)
    CHECK(error_of([] {
            parallel_chunks(1000, 8, 1, [](std::size_t begin, std::size_t, unsigned) {
              if (begin < 100) return;
              if (begin == 100) std::this_thread::sleep_for(std::chrono::milliseconds(2));
              throw Error::at("page " + std::to_string(begin), "broken");
            });
          }) == "page 100: broken");
}
