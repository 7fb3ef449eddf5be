// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
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

/// Time of one evaluation. It is measured in rounds, each of a few short repeats of every way in a changing
/// order. The shortest repeat of a round counts, because other programs can only make a repeat longer.
struct RunTime {
  double median_ns = 0, first_quartile_ns = 0, third_quartile_ns = 0;  // over the rounds
  double ratio = 1;               // to the time of the table's base row: see set_ratios()
  double least_ns = 0;            // the shortest repeat of all
  std::vector<double> rounds_ns;  // the shortest repeat of each round; NaN: no part of that round
};

/// What the report says of a way on one machine, with one build, at the clock frequencies of one run: that
/// alone is in the rounds. From one build to another, ratios of times were seen to move by 18 %. A way is beaten by a way to the same truth that is closer to it and takes
/// at most same_time times as long, or that is as close and faster by more than that factor. Errors within
/// 1 % are equal, and errors below 1e-5 are none.
enum class Verdict {
  not_timed,
  alone,        // no other way to the same truth was timed
  unbeaten,     // no way beats it
  beaten,       // a way beats it
  not_settled,  // the rounds do not tell whether a way beats it
};
std::string_view name(Verdict verdict);  // "not timed", "alone", "unbeaten", "beaten", "not settled"

/// Times within this factor count as equal: nobody gives up accuracy for a tenth of the time, and the order
/// of ways that run the same instructions would be chance.
inline constexpr double same_time = 1.1;

/// The error of a way for one of the materials that the errors of a row are taken over.
struct ErrorPoint {
  std::string material;
  double error = 0;       // by the plotted metric's measure
  bool doubtful = false;  // its data are doubtful or computed: not in the errors of the row
};

/// One way of computing the same thing.
struct ErrorTimeRow {
  std::string id, title;
  std::vector<double> errors = {};   // one per metric of the table
  std::optional<RunTime> time = {};  // none: not timed (a reference, or time has no meaning)
  std::string note = {};
  std::string truth = {};               // only ways of the same are compared; empty: the table has one
  std::vector<ErrorPoint> points = {};  // one per material; empty: the errors are not by material
  Verdict verdict = Verdict::not_timed;
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

/// A row of the report's overview: what to take, and for whom.
struct ErrorTimePick {
  std::string whom;          // "drawing metals"
  std::string table, row;    // ids within the family
  std::string why;           // half a sentence
  std::string command = {};  // that takes it, or chooses for one material: "etak choose gold"; empty: none
};

/// Work to be timed: one call of `body` makes `evaluations` evaluations.
struct TimedCase {
  std::string id;
  std::size_t evaluations = 1;
  std::function<void()> body;
};

/// Cases that are timed in the same rounds. A case times the rows of its id in every table of `tables`.
struct TimedSet {
  std::vector<std::string> tables;  // ids within the family
  std::vector<TimedCase> cases;
  double scale = 1;             // from nanoseconds to the time unit of the tables
  bool starts_threads = false;  // the cases work on several threads: their time is that of the wall clock
};

/// Pictures of one size below each other, as a figure of a family: what each way makes of the same.
struct ErrorTimeStrips {
  /// The picture that one way makes.
  ///   note   its error, in words
  ///   png    the picture, a PNG file
  struct Row {
    std::string title, note, png;
  };
  std::string title, columns, rows;  // columns, rows: what changes from left to right, and downwards in each
  std::vector<Row> ways;
};

/// The tables of a family, and the texts around them in the report.
struct ErrorTimeFamily {
  std::string id;      // "fresnel": the name of --family
  std::string letter;  // "b"
  std::string title;
  std::string reference;  // what the errors are taken against
  std::string grid;       // the inputs that the errors are taken over
  std::string advice;     // one sentence: what a user should choose and why
  std::vector<ErrorTimePick> picks;
  std::vector<ErrorTimeTable> tables;
  std::vector<std::string> notes;
  std::vector<ErrorTimeStrips> strips = {};
  std::vector<TimedSet> timed = {};  // what time_families() has to time; empty once it has
};

/// Sets the ratio of each timed row to the base row of its table: the median over the rounds that both were
/// part of.
void set_ratios(ErrorTimeTable& table);

/// Sets the verdicts of the rows. Ways are compared round by round, so that what slows a whole round down
/// does not count; the median of the rounds must lie beyond the bound by a margin that their spread gives.
void set_verdicts(ErrorTimeTable& table);

/// Which rows need more rounds: those that are not settled, and those that they have to be told from.
std::vector<bool> open_rows(const ErrorTimeTable& table);

/// Replaces each pick that another way beats by the one of these ways that is closest and is not beaten
/// itself, and says so in its `why`. Which way is beaten depends on the machine; what to pick must not.
void settle_picks(ErrorTimeFamily& family);

/// The program, machine and settings that a report was made with.
struct ReportHeader {
  std::string version, commit, cpu, gpu, compiler, flags;
  unsigned threads = 1;
  std::size_t repeats = 0;
  double empty_loop_ns = 0;  // time of an empty loop, as a check of the clock
  std::string effort;        // "quick" or "full"
};

/// How cases are timed.
struct TimingOptions {
  std::size_t repeats = 31;     // of each case; all cases are interleaved, in a changing order
  double seconds_a_case = 0.2;  // for these repeats of a case together; 0: a repeat is a single call
  std::function<void(std::size_t done, std::size_t all)> progress = {};  // called before each repeat
  // Where the repeats of all cases of a set would take longer than this, there are fewer; one at least.
  double most_seconds = std::numeric_limits<double>::infinity();
  std::size_t more_rounds = 0;  // most rounds that are added where the first ones do not settle the verdicts
  std::optional<std::chrono::steady_clock::time_point> until = {};  // no round is added after it
};
/// The repeats of a case in one round, where a call is short enough for several.
inline constexpr std::size_t repeats_a_round = 3;

/// Times the cases by Google Benchmark (target etak::study_run). Times are processor time of the calling
/// thread, which goes on only while the thread runs, so that a repeat that was interrupted is no longer than
/// another.
///   empty_loop_ns   not null: set to the time of an empty loop
std::vector<RunTime> time_cases(std::span<const TimedCase> cases, const TimingOptions& options,
                                double* empty_loop_ns = nullptr);

/// How much a family measures.
struct ReportOptions {
  bool full = false;  // false: coarser grids where these take long, and fewer repeats; errors stay comparable
  unsigned threads = 1;
  bool cpu = true, gl = false;
};

/// Times the cases of all families and sets times, ratios and verdicts of their rows. Each set of cases gets
/// a round; then the sets get their further rounds in turn, the quickest set first, so that none uses up the
/// time of the others: first rounds of all their cases, then rounds of those whose verdicts are open. A set
/// that is settled gets none. `options.progress` gets the number of sets that had a round.
void time_families(std::span<ErrorTimeFamily> families, const TimingOptions& options);

/// A family before it is measured.
struct FamilyEntry {
  std::string_view id;  // that of the ErrorTimeFamily
  // Measures the errors of a family and names the cases to be timed.
  ErrorTimeFamily (*measure)(const ReportOptions&);
};
/// All families, in the order of core/study/families/families.inc (target etak::study_run).
std::span<const FamilyEntry> all_families();

/// The header for this machine and this build, with threads and effort of `options`. The caller fills in
/// the rest.
ReportHeader report_header(const ReportOptions& options);

}  // namespace etak
