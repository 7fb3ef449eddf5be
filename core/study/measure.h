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

// Shared by the families of error_time.h: random inputs that are the same in every run, and a function that
// keeps timed loops from being optimised away.

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

/// Times the first rows of the table, row i by case i, and marks the rows that others dominate.
inline void add_times(ErrorTimeTable& table, std::span<const TimedCase> cases, const ReportOptions& options) {
  const auto times = time_cases(cases, options.timing);
  for (std::size_t i = 0; i < times.size(); ++i) table.rows[i].time = times[i];
  mark_dominated(table);
}

}  // namespace etak
