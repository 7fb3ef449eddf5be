// SPDX-License-Identifier: Apache-2.0
#include "core/study/error_time.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/functions.h"

namespace etak {
namespace {

// A median of ratios that lies nearer to its bound than this is not trusted, however little the rounds
// differ: addresses of buffers, for one, change the times from one process to the next.
constexpr double least_margin = 0.03;
constexpr double few_rounds_margin = 0.25;  // the same where there are too few rounds to tell their spread

// Standard errors of the median that the margin is at least: 2.5, and more where the spread itself comes from
// few rounds, as in Student's distribution (3 rounds 9.1, 5 rounds 3.9, 9 rounds 3.1).
double margin_errors(std::size_t rounds) {
  const double freedom = static_cast<double>(rounds) - 1;
  return 2.5 * freedom / (freedom - 1.45);
}

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
    if (const double log = math::log(a.rounds_ns[i] / (factor * b.rounds_ns[i])); std::isfinite(log))
      logs.push_back(log);
  if (logs.empty()) return Answer::open;
  const double median = median_of(logs);
  for (double& log : logs) log = std::abs(log - median);
  // 1.4826 times the median distance estimates the standard deviation, 1.2533 that of a median by it.
  const double error = 1.2533 * 1.4826 * median_of(logs) / std::sqrt(static_cast<double>(logs.size()));
  const bool few = logs.size() < 3;
  const double margin = few ? few_rounds_margin : least_margin,
               spread = few ? 0 : margin_errors(logs.size()) * error;
  if (std::abs(median) < std::max(margin, spread)) return Answer::open;
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

void set_ratios(ErrorTimeTable& table) {
  const auto base = std::find_if(table.rows.begin(), table.rows.end(),
                                 [&](const ErrorTimeRow& row) { return row.id == table.base; });
  if (base == table.rows.end() || !base->time) return;
  for (ErrorTimeRow& row : table.rows) {
    if (!row.time) continue;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(row.time->rounds_ns.size(), base->time->rounds_ns.size()); ++i)
      if (const double ratio = row.time->rounds_ns[i] / base->time->rounds_ns[i]; std::isfinite(ratio))
        ratios.push_back(ratio);
    if (!ratios.empty()) row.time->ratio = median_of(ratios);
  }
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

void settle_picks(ErrorTimeFamily& family) {
  std::erase_if(family.picks, [&](ErrorTimePick& pick) {
    const auto table = std::find_if(family.tables.begin(), family.tables.end(),
                                    [&](const ErrorTimeTable& each) { return each.id == pick.table; });
    if (table == family.tables.end()) return false;
    const auto row = std::find_if(table->rows.begin(), table->rows.end(),
                                  [&](const ErrorTimeRow& each) { return each.id == pick.row; });
    if (row == table->rows.end() || row->verdict != Verdict::beaten) return false;
    const ErrorTimeRow* best = nullptr;
    for (const ErrorTimeRow& other : table->rows)
      if (other.verdict != Verdict::beaten && beats(*table, other, *row) == Answer::yes &&
          (best == nullptr || other.errors[table->plotted] < best->errors[table->plotted]))
        best = &other;
    if (best == nullptr) return true;  // the ways beat each other in a circle
    pick.why = (best->errors[table->plotted] * same_error < row->errors[table->plotted]
                    ? "on this machine closer than \"" + row->title + "\" for at most a tenth more time"
                    : "on this machine as close as \"" + row->title + "\" and faster");
    pick.row = best->id;
    pick.command.clear();  // it takes the other way
    return false;
  });
}

}  // namespace etak
