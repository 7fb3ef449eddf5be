// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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

inline constexpr double ms_of_ns = 1e-6;

/// The time in another unit: all its times by `factor`.
inline RunTime in_unit(RunTime time, double factor) {
  for (double* part : {&time.median_ns, &time.first_quartile_ns, &time.third_quartile_ns, &time.least_ns})
    *part *= factor;
  for (double& each : time.rounds_ns) each *= factor;
  return time;
}

/// Times the cases until the verdicts of all tables are settled, as far as the options allow.
///   put    sets the times of the tables' rows
///   case_of(table, row)   the case that timed a row, or the number of cases for a row without one
template <class Put, class CaseOf>
void time_tables(std::span<ErrorTimeTable> tables, std::span<const TimedCase> cases,
                 const TimingOptions& timing, Put put, CaseOf case_of) {
  const auto take = [&](std::span<const RunTime> times) {
    put(times);
    std::vector<bool> open(cases.size() + 1);
    for (ErrorTimeTable& table : tables) {
      set_verdicts(table);
      const std::vector<bool> rows = open_rows(table);
      for (std::size_t r = 0; r < rows.size(); ++r)
        if (rows[r]) open[case_of(table, r)] = true;
    }
    open.pop_back();
    return open;
  };
  time_cases(cases, timing, take);
}

/// Times the first rows of the tables, row i of each by case i, and sets the verdicts.
///   scale   factor of the times, from nanoseconds to the unit of the tables
inline void add_times(std::span<ErrorTimeTable> tables, std::span<const TimedCase> cases,
                      const TimingOptions& timing, double scale = 1) {
  time_tables(
      tables, cases, timing,
      [&](std::span<const RunTime> times) {
        for (ErrorTimeTable& table : tables)
          for (std::size_t i = 0; i < times.size(); ++i) table.rows[i].time = in_unit(times[i], scale);
      },
      [&](const ErrorTimeTable&, std::size_t row) { return std::min(row, cases.size()); });
}
inline void add_times(ErrorTimeTable& table, std::span<const TimedCase> cases, const ReportOptions& options) {
  add_times(std::span(&table, 1), cases, options.timing);
}

}  // namespace etak
