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

/// Seconds that each stage of an F0 run took, added up over threads, and the bytes that were read.
struct F0StageTimes {
  double read = 0, parse = 0, print = 0;
  F0Timing f0;
  std::size_t bytes = 0;

  F0StageTimes& operator+=(const F0StageTimes& other);
};

/// Values that all workers of a run share.
struct F0Job {
  const F0Solver& solver;
  TableOptions tables;
  bool axis_average = false;
  bool with_source = false;  // fill in F0Row::source: pages are then parsed a second time for their citation
  bool timed = false;
};

/// The result for one input.
struct F0Outcome {
  enum class Kind {
    answered,   // `row` holds a result, possibly a refused one
    nonlinear,  // a database file of n2 data: no page
    other,      // a database file without optical constants: no page
    prose       // a text file of a folder that holds no table
  };
  Kind kind = Kind::answered;
  bool without_optics = false;  // the page gives no n and is refused: it has no curves to show
  F0Row row;
};

/// Computes F0 of inputs one after the other, on one thread; its buffers are used again for the next input.
class alignas(64) F0Worker {
 public:
  /// Throws Error for input that cannot be read or understood.
  F0Outcome answer(const MaterialInput& input, const F0Job& job);

  /// Adds the time since the last lap to `stage`; does nothing where the job is not timed.
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
