// SPDX-License-Identifier: Apache-2.0
#include "core/study/error_time.h"

namespace etak {

void mark_dominated(ErrorTimeTable& table) {
  const std::size_t metric = table.plotted;
  for (ErrorTimeRow& row : table.rows) {
    row.pareto = row.time.has_value();
    row.dominated = false;
    if (!row.time) continue;
    for (const ErrorTimeRow& other : table.rows) {
      if (&other == &row || !other.time) continue;
      const double faster = row.time->median_ns - other.time->median_ns;
      const double closer = row.errors[metric] - other.errors[metric];
      if ((faster >= 0 && closer > 0) || (faster > 0 && closer >= 0)) row.pareto = false;
      // Errors are exact numbers; only times have a spread, which the difference must exceed.
      if (closer > 0 && other.time->third_quartile_ns < row.time->first_quartile_ns) row.dominated = true;
    }
  }
}

}  // namespace etak
