// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/study/error_time.h"

namespace etak {

// Shared by the families of error_time.h and what times them: random inputs that are the same in every run,
// and a function that keeps timed loops from being optimised away.

using Random = SplitMix;

/// Random numbers from `low` to `high` as inputs of a timed loop; equal arguments give equal numbers.
inline std::shared_ptr<const std::vector<float>> random_floats(std::size_t count, float low, float high,
                                                               std::uint64_t seed = 1) {
  Random random(seed);
  auto out = std::make_shared<std::vector<float>>(count);
  for (float& value : *out) value = static_cast<float>(random.uniform(low, high));
  return out;
}

/// Makes the compiler assume that the memory is read here, so that it keeps the loop that has written it.
inline void keep(const void* memory) {
  asm volatile("" : : "g"(memory) : "memory");
}

inline constexpr double ms_of_ns = 1e-6;

/// The time in another unit: all its times by `factor`.
inline RunTime in_unit(RunTime time, double factor) {
  for (double* part : {&time.median_ns, &time.first_quartile_ns, &time.third_quartile_ns, &time.least_ns})
    *part *= factor;
  for (double& each : time.rounds_ns) each *= factor;
  return time;
}

}  // namespace etak
