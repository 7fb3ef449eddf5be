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

// Error against run time: the results of the families of `etak report`. A family compares ways to compute the
// same thing.

/// An error that is measured for every row of a table.
struct ErrorMetric {
  std::string id;     // "max_abs"
  std::string title;  // "largest |F - truth|"
  std::string unit;   // "", "codes", "dE2000", "%"
};

/// Time of one evaluation: median and quartiles over interleaved repeats.
struct RunTime {
  double median_ns = 0, first_quartile_ns = 0, third_quartile_ns = 0;
  double ratio = 1;     // to the time of the table's base row: median of the ratios of the repeats
  double least_ns = 0;  // the shortest repeat, which other programs disturbed least
};

/// One way of computing the same thing.
struct ErrorTimeRow {
  std::string id, title;
  std::vector<double> errors;   // one per metric of the table
  std::optional<RunTime> time;  // none: not timed (a reference, or time has no meaning)
  std::string note;
  bool pareto = false;     // no other row is better in error or time and at least as good in the other
  bool dominated = false;  // a row has a smaller error and is faster, with quartile ranges that do not meet
};

/// Rows that may be compared with each other.
struct ErrorTimeTable {
  std::string id, title;  // "metals"
  std::vector<ErrorMetric> metrics;
  std::size_t plotted = 0;  // index of the metric on the y axis of the scatter plot
  std::string time_unit = "ns per evaluation";
  std::string base;  // id of the row that ratios refer to
  std::vector<ErrorTimeRow> rows;
};

/// The tables of a family, and the texts around them in the report.
struct ErrorTimeFamily {
  std::string id;      // "fresnel": the name of --family
  std::string letter;  // "b"
  std::string title;
  std::string reference;  // what the errors are taken against
  std::string grid;       // the inputs that the errors are taken over
  std::string advice;     // one sentence: what a user should choose and why
  std::vector<ErrorTimeTable> tables;
  std::vector<std::string> notes;
};

/// Sets `pareto` and `dominated` of the rows with a time.
void mark_dominated(ErrorTimeTable& table);

/// The program, machine and settings that a report was made with.
struct ReportHeader {
  std::string version, commit, cpu, gpu, compiler, flags;
  unsigned threads = 1;
  std::size_t repeats = 0;
  double empty_loop_ns = 0;  // time of an empty loop, as a check of the clock
  std::string effort;        // "quick" or "full"
};

/// Work to be timed: one call of `body` makes `evaluations` evaluations.
struct TimedCase {
  std::string id;
  std::size_t evaluations = 1;
  std::function<void()> body;
};

/// How cases are timed.
struct TimingOptions {
  std::size_t repeats = 31;     // of each case; all cases are interleaved, in a changing order
  double seconds_a_case = 0.2;  // for all repeats of a case together
  std::function<void(std::size_t done, std::size_t all)> progress = {};  // called before each repeat
};

/// Times the cases on one thread by Google Benchmark (target etak::study_run). Returns a RunTime for each
/// case, with the ratio to the first case.
///   empty_loop_ns   not null: set to the time of an empty loop
std::vector<RunTime> time_cases(std::span<const TimedCase> cases, const TimingOptions& options,
                                double* empty_loop_ns = nullptr);

/// How much a family measures.
struct ReportOptions {
  bool full = false;  // false: coarser grids where these take long, and fewer repeats; errors stay comparable
  TimingOptions timing;
  unsigned threads = 1;
  bool cpu = true, gl = false;
};

/// A family before it is measured.
struct FamilyEntry {
  std::string_view id;  // that of the ErrorTimeFamily
  ErrorTimeFamily (*measure)(const ReportOptions&);
};
/// All families, in the order of core/study/families/families.inc (target etak::study_run).
std::span<const FamilyEntry> all_families();

/// The header for this machine and this build, with repeats, threads and effort of `options`. The caller
/// fills in `gpu` and `empty_loop_ns`.
ReportHeader report_header(const ReportOptions& options);

}  // namespace etak
