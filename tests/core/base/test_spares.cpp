// SPDX-License-Identifier: Apache-2.0
#include "core/base/spares.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

using namespace etak;

namespace {

// Counts the objects that there are, and tells whether two threads have the same one.
struct Watched {
  static inline std::atomic<int> alive{0};
  std::atomic<bool> taken{false};
  int uses = 0;
  Watched() { ++alive; }
  ~Watched() { --alive; }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;
};

}  // namespace

TEST_CASE("a thread gets back the object that it gave back, as it was") {
  {
    Spares<Watched> spares;
    for (int i = 0; i < 5; ++i) {
      const Spares<Watched>::Taken taken(spares);
      CHECK((*taken).uses == i);
      ++(*taken).uses;
    }
    CHECK(Watched::alive == 1);
  }
  CHECK(Watched::alive == 0);
}

TEST_CASE("an object that is taken is not given again, and one of the two is kept") {
  {
    Spares<Watched> spares;
    {
      const Spares<Watched>::Taken one(spares), other(spares);
      CHECK(&*one != &*other);
      CHECK(Watched::alive == 2);
    }
    CHECK(Watched::alive == 1);
  }
  CHECK(Watched::alive == 0);
}

TEST_CASE("no two threads have the same object, and the objects outlive the threads, not the spares") {
  constexpr int threads = 100, rounds = 2000;
  std::atomic<int> shared{0};
  {
    Spares<Watched> spares;
    std::vector<std::thread> all;
    for (int i = 0; i < threads; ++i)
      all.emplace_back([&] {
        for (int round = 0; round < rounds; ++round) {
          const Spares<Watched>::Taken taken(spares);
          if ((*taken).taken.exchange(true)) ++shared;
          ++(*taken).uses;
          (*taken).taken = false;
        }
      });
    for (std::thread& thread : all) thread.join();
    CHECK(Watched::alive >= 1);
    CHECK(Watched::alive <= 64);
  }
  CHECK(shared == 0);
  CHECK(Watched::alive == 0);
}
