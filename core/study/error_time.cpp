// SPDX-License-Identifier: Apache-2.0
#include "core/study/error_time.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace etak {
namespace {

// A median of ratios that lies nearer to its bound than this is not trusted, however little the rounds
// differ: addresses of buffers, for one, change the times from one process to the next.
constexpr double least_margin = 0.03;
constexpr double few_rounds_margin = 0.25;  // the same where there are too few rounds to tell their spread
constexpr double margin_errors = 2.5;       // standard errors of the median that the margin is at least

// Errors within this factor count as equal, and errors below `no_error` as none, whatever their unit is: the
// last digits of a fit are no reason to take a slower way.
constexpr double same_error = 1.01, no_error = 1e-5;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

enum class Answer { no, yes, open };

// Whether `a` takes at most `factor` times as long as `b`.
Answer takes_at_most(const RunTime& a, const RunTime& b, double factor) {
  std::vector<double> logs;
  for (std::size_t i = 0; i < std::min(a.rounds_ns.size(), b.rounds_ns.size()); ++i)
    if (const double log = std::log(a.rounds_ns[i] / (factor * b.rounds_ns[i])); std::isfinite(log))
      logs.push_back(log);
  if (logs.empty()) return Answer::open;
  const double median = median_of(logs);
  for (double& log : logs) log = std::abs(log - median);
  // 1.4826 times the median distance estimates the standard deviation, 1.2533 that of a median by it.
  const double error = 1.2533 * 1.4826 * median_of(logs) / std::sqrt(static_cast<double>(logs.size()));
  const double margin = logs.size() < 3 ? few_rounds_margin : least_margin;
  if (std::abs(median) < std::max(margin, margin_errors * error)) return Answer::open;
  return median < 0 ? Answer::yes : Answer::no;
}

// Whether `other` beats `row`; nothing where it cannot, whatever the times are.
std::optional<Answer> beats(const ErrorTimeTable& table, const ErrorTimeRow& other, const ErrorTimeRow& row) {
  const double own = std::max(row.errors[table.plotted], no_error),
               theirs = std::max(other.errors[table.plotted], no_error);
  if (&other == &row || !other.time || other.truth != row.truth || theirs > own * same_error)
    return std::nullopt;
  return takes_at_most(*other.time, *row.time, theirs * same_error < own ? same_time : 1 / same_time);
}

}  // namespace

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 5> names{"not timed", "alone", "unbeaten", "beaten", "not settled"};
  return names[static_cast<std::size_t>(verdict)];
}

void set_verdicts(ErrorTimeTable& table) {
  for (ErrorTimeRow& row : table.rows) {
    row.verdict = Verdict::not_timed;
    if (!row.time) continue;
    bool alone = true, beaten = false, open = false;
    for (const ErrorTimeRow& other : table.rows) {
      alone = alone && (&other == &row || !other.time || other.truth != row.truth);
      const auto answer = beats(table, other, row);
      beaten = beaten || answer == Answer::yes;
      open = open || answer == Answer::open;
    }
    row.verdict = alone    ? Verdict::alone
                  : beaten ? Verdict::beaten
                  : open   ? Verdict::not_settled
                           : Verdict::unbeaten;
  }
}

std::vector<bool> open_rows(const ErrorTimeTable& table) {
  std::vector<bool> out(table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.rows[i].verdict != Verdict::not_settled) continue;
    out[i] = true;
    for (std::size_t j = 0; j < table.rows.size(); ++j)
      if (beats(table, table.rows[j], table.rows[i]) == Answer::open) out[j] = true;
  }
  return out;
}

}  // namespace etak
