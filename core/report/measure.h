// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace etak {

// What the families of error_time.h share: random inputs that are the same in every run, and a fence for
// timed loops.

/// SplitMix64 (Steele, Lea and Flood 2014): small, and the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// Uniform in [0, 1).
  double uniform() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t state_;
};

/// Inputs for a timed loop; the same for equal arguments.
inline std::shared_ptr<const std::vector<float>> random_floats(std::size_t count, float low, float high,
                                                               std::uint64_t seed = 1) {
  Random random(seed);
  auto out = std::make_shared<std::vector<float>>(count);
  for (float& value : *out) value = static_cast<float>(random.uniform(low, high));
  return out;
}

/// The compiler must take what `memory` points to as read: a timed loop's results are not thrown away.
inline void keep(const void* memory) {
  asm volatile("" : : "g"(memory) : "memory");
}

}  // namespace etak
