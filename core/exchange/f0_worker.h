// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/stopwatch.h"
#include "core/exchange/f0_row.h"
#include "core/exchange/material_input.h"
#include "core/exchange/rii/rii_page.h"

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
  bool with_source = false;  // fill in F0Row::source and F0Row::clear
  bool timed = false;
  bool materials = false;         // fill in F0Outcome::material in place of computing results
  std::optional<Coat> coat = {};  // fill in F0Row::coat
  bool bands = false;             // fill in F0Row::band
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
  F0Row row;
  std::optional<Material>
      material;  // where the job asks for it; none of a page that gives no n and is refused
};

/// The layers of a stack and its base; none of other data, and of a stack whose media are not looked up.
std::vector<F0Layer> layers_of(const Dataset& dataset);

/// What a row says of its dataset, besides the result and what it is called by.
void set_record(F0Row& row, const Material& material, const Dataset& dataset);

/// The band of a row's result, or why it has none.
///   solver   that made the result
void set_band(F0Row& row, const F0Solver& solver, const Material& material, const Dataset& dataset);

/// Computes F0 of inputs one after the other, on one thread; its buffers are used again for the next input.
class alignas(64) F0Worker {
 public:
  /// Throws Error for input that cannot be read or understood.
  F0Outcome answer(const MaterialInput& input, const F0Job& job);

  F0StageTimes times;

 private:
  F0Outcome answer_in_memory(const MaterialInput& input, const F0Job& job);
  void answer_page(const MaterialInput& input, const F0Job& job, F0Outcome& out);
  void average_pages(const MaterialInput& input, const F0Job& job, F0Row& row);
  void answer_dataset(const Material& material, const MaterialInput& input, const F0Job& job, F0Row& row);
  void solve(const Optics& optics, Flags flags, const F0Job& job, F0Row& row) {
    finish(optics, job.solver.solve(optics, flags, job.timed ? &times.f0 : nullptr), job, row);
  }
  void finish(const Optics& optics, F0Result result, const F0Job& job, F0Row& row);

  std::string text_;
  RiiPage page_;
};

}  // namespace etak
