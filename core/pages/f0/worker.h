// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "core/exchange/material_input.h"
#include "core/exchange/rii/rii_page.h"
#include "core/material/f0.h"
#include "core/pages/f0/report.h"

namespace etak {

/// Seconds per stage of an F0 run, and the bytes read; added up over threads.
struct F0StageTimes {
  double read = 0, parse = 0, print = 0;
  F0Timing f0;
  std::size_t bytes = 0;

  F0StageTimes& operator+=(const F0StageTimes& other);
};

/// What all workers of a run share.
struct F0Job {
  const F0Solver& solver;
  TableOptions tables;
  bool axis_average = false;
  bool with_source = false;  // fill F0Row::source; pages are then read a second time for their citation
  bool timed = false;
};

/// What came of one input.
struct F0Outcome {
  enum class Kind {
    answered,   // `row` holds a result, possibly a refused one
    nonlinear,  // a database file of n2 data: no page
    other,      // a database file without optical constants: no page
    prose       // a text of a folder that is no table
  };
  Kind kind = Kind::answered;
  bool without_optics = false;  // a page that is refused because it gives no n: nothing of it can be shown
  F0Row row;
};

/// Answers inputs one after the other, on one thread, with buffers it keeps.
class alignas(64) F0Worker {
 public:
  /// Throws Error for input that cannot be read or understood.
  F0Outcome answer(const MaterialInput& input, const F0Job& job);

  /// Adds the time since the last lap to `stage`; nothing when the job is not timed.
  void lap(double& stage, const F0Job& job);
  void start_lap(const F0Job& job);

  F0StageTimes times;

 private:
  F0Outcome answer_in_memory(const MaterialInput& input, const F0Job& job);
  F0Outcome answer_page(const MaterialInput& input, const F0Job& job);
  F0Result average_pages(const MaterialInput& input, const F0Job& job, F0Row& row);
  void answer_dataset(const Material& material, const MaterialInput& input, const F0Job& job, F0Row& row);
  F0Result solve(OpticalConstants& constants, Flags flags, const F0Job& job);

  std::string text_;
  RiiPage page_;
  std::chrono::steady_clock::time_point lap_begin_;
};

}  // namespace etak
