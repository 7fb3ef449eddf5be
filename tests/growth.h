// SPDX-License-Identifier: Apache-2.0
// Checks how the time of a reader grows with its input.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <ctime>
#include <limits>
#include <string>

namespace etak::test {

/// Processor time of `work` in seconds: the least of some runs, because a busy machine can only add to a
/// time.
template <class Work>
double seconds_of(const Work& work, int runs = 3) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

/// Checks over four doublings, from `count` things to 16 times as many, that the time of work(made(things))
/// is nearly proportional to the number of things. For 16 times the things, 64 times the time is allowed,
/// because of logarithms and of data that do not fit the caches; a quadratic reader takes 256 times. Times
/// below 2 ms are too short to be measured and count as 2 ms.
///   name   name of the case, for its message
///   made   makes the input from the number of things; it is not timed
template <class Made, class Work>
void check_growth(const char* name, std::size_t count, const Made& made, const Work& work) {
  constexpr double shortest = 0.002, most = 64;
  std::array<double, 5> seconds{};
  for (std::size_t doubling = 0; doubling < seconds.size(); ++doubling) {
    const auto input = made(count << doubling);
    seconds[doubling] = seconds_of([&] { work(input); });
  }
  INFO(name << ": " << seconds[0] << " s, doubled " << seconds[1] << ", " << seconds[2] << ", " << seconds[3]
            << ", " << seconds[4]);
  CHECK(seconds.back() < most * std::max(shortest, seconds.front()));
}

/// The text `head`, then `count` items with commas between them, then `tail`.
///   item   makes an item from its number
template <class Item>
std::string listed(const std::string& head, std::size_t count, const Item& item, const std::string& tail) {
  std::string out = head;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ',';
    out += item(i);
  }
  return out + tail;
}

}  // namespace etak::test
