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

// What the families of error_time.h share: random inputs that are the same in every run, and a fence for
// timed loops.

using Random = SplitMix;

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

/// Times the table's first rows, one case each, and says which rows are beaten.
inline void add_times(ErrorTimeTable& table, std::span<const TimedCase> cases, const ReportOptions& options) {
  const auto times = time_cases(cases, options.timing);
  for (std::size_t i = 0; i < times.size(); ++i) table.rows[i].time = times[i];
  mark_dominated(table);
}

}  // namespace etak
