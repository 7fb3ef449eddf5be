// SPDX-License-Identifier: Apache-2.0
// How the time of a reader grows with what it reads.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <ctime>
#include <limits>
#include <string>

namespace etak::test {

/// Processor time of `work`, the least of some runs, in seconds: a machine in use only ever adds to a time.
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

/// Checks over four doublings, from `count` things to 16 times as many, that work(made(things)) takes time in
/// proportion, but for a logarithm and for what leaves the caches: 16 times the things may take 64 times as
/// long, where a quadratic reader takes 256 times. What takes less than 2 ms is too short to be measured and
/// counts as that.
///   name   of the case, for its message
///   made   makes the input, which is not timed, from the number of things
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

/// `head`, then `count` items with commas between them, then `tail`.
///   item   makes one from its number
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
