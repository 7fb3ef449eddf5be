// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace etak {

/// Columns begin .. end - 1 of a row.
struct RowRun {
  int row = 0, begin = 0, end = 0;
  friend bool operator==(const RowRun&, const RowRun&) = default;
};

/// A set of texels: runs in the order of their rows, then of their columns, which neither touch nor overlap.
using RowRuns = std::vector<RowRun>;

inline bool holds(const RowRuns& runs, int column, int row) {
  const auto after =
      std::upper_bound(runs.begin(), runs.end(), std::tuple(row, column),
                       [](const auto& at, const RowRun& run) { return at < std::tuple(run.row, run.begin); });
  return after != runs.begin() && std::prev(after)->row == row && column < std::prev(after)->end;
}

inline std::uint64_t count_of(const RowRuns& runs) {
  std::uint64_t out = 0;
  for (const RowRun& run : runs) out += static_cast<std::uint64_t>(run.end - run.begin);
  return out;
}

/// Appends the runs of a row in which set(column) is true, of columns begin .. end - 1.
template <class Set>
void add_row(RowRuns& runs, int row, int begin, int end, const Set& set) {
  for (int x = begin; x < end;) {
    if (!set(x)) {
      ++x;
      continue;
    }
    const int first = x;
    while (x < end && set(x)) ++x;
    runs.push_back({row, first, x});
  }
}

/// The texels of a level that some texels of level 0 touch, 2^level of them to one.
inline RowRuns at_level(const RowRuns& runs, int level) {
  RowRuns out;
  for (std::size_t first = 0; first < runs.size();) {
    const int row = runs[first].row >> level;
    RowRuns spans;
    for (; first < runs.size() && runs[first].row >> level == row; ++first)
      spans.push_back({row, runs[first].begin >> level, ((runs[first].end - 1) >> level) + 1});
    std::ranges::sort(spans, {}, &RowRun::begin);
    for (const RowRun& span : spans)
      if (!out.empty() && out.back().row == row && span.begin <= out.back().end)
        out.back().end = std::max(out.back().end, span.end);
      else
        out.push_back(span);
  }
  return out;
}

}  // namespace etak
