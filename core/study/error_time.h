// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

// Error against run time: what every family of `etak report` gives.

/// What is measured of a row besides its time.
struct ErrorMetric {
  std::string id;     // "max_abs"
  std::string title;  // "largest |F - truth|"
  std::string unit;   // "", "codes", "dE2000", "%"
};

/// Time of one evaluation: median and quartiles over interleaved repeats.
struct RunTime {
  double median_ns = 0, first_quartile_ns = 0, third_quartile_ns = 0;
  double ratio = 1;     // of medians to the table's base row, repeat by repeat
  double least_ns = 0;  // of all repeats: the time without disturbance
};

/// One way of computing the same thing.
struct ErrorTimeRow {
  std::string id, title;
  std::vector<double> errors;   // one per metric of the table
  std::optional<RunTime> time;  // none: not timed (a reference, or time has no meaning)
  std::string note;
  bool pareto = false;     // no other row is at least as good in both
  bool dominated = false;  // some row is better in both by more than both quartile ranges
};

/// Rows that may be compared with each other.
struct ErrorTimeTable {
  std::string id, title;  // "metals"
  std::vector<ErrorMetric> metrics;
  std::size_t plotted = 0;  // the metric of the scatter's y axis
  std::string time_unit = "ns per evaluation";
  std::string base;  // id of the row that ratios refer to
  std::vector<ErrorTimeRow> rows;
};

struct ErrorTimeFamily {
  std::string id;      // "fresnel": the name of --family
  std::string letter;  // "b"
  std::string title;
  std::string reference;  // what the errors are against
  std::string grid;       // over what
  std::string advice;     // one sentence: what a user should pick and why
  std::vector<ErrorTimeTable> tables;
  std::vector<std::string> notes;
};

/// Sets `pareto` and `dominated` of the rows with a time.
void mark_dominated(ErrorTimeTable& table);

/// What a report depends on besides its numbers.
struct ReportHeader {
  std::string version, commit, cpu, gpu, compiler, flags;
  unsigned threads = 1;
  std::size_t repeats = 0;
  double empty_loop_ns = 0;  // clock check: what timing nothing gives
  std::string effort;        // "quick" or "full"
};

/// Something to time: `body` does `evaluations` of them.
struct TimedCase {
  std::string id;
  std::size_t evaluations = 1;
  std::function<void()> body;
};

struct TimingOptions {
  std::size_t repeats = 31;     // interleaved, in an order that changes from round to round
  double seconds_a_case = 0.2;  // of each case, over all repeats
  std::function<void(std::size_t done, std::size_t all)> progress = {};  // told before each repeat
};

/// One RunTime per case, ratios to the first. Through Google Benchmark (target etak::study_run); single
/// thread.
std::vector<RunTime> time_cases(std::span<const TimedCase> cases, const TimingOptions& options,
                                double* empty_loop_ns = nullptr);

/// How much a family does.
struct ReportOptions {
  bool full = false;  // quick: coarser grids for what takes long, fewer repeats; errors stay comparable
  TimingOptions timing;
  unsigned threads = 1;
  bool cpu = true, gl = false;
  std::string shared_folder;  // of test data for families that use published sets; empty: without them
};

/// All families, in the order of core/study/families/families.inc (target etak::study_run).
struct FamilyEntry {
  std::string_view id;  // that of the family it makes
  ErrorTimeFamily (*measure)(const ReportOptions&);
};
std::span<const FamilyEntry> all_families();

/// This machine and this build; repeats, threads and effort from `options`. `gpu` and `empty_loop_ns` are the
/// caller's.
ReportHeader report_header(const ReportOptions& options);

}  // namespace etak
