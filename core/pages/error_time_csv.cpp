// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/pages/error_time_report.h"

namespace etak {
namespace {

constexpr int error_digits = 9, time_digits = 4;
constexpr std::string_view column_names =
    "family,table,row,metric,unit,error,time_unit,median,first_quartile,third_quartile,ratio,verdict\n";

void append_rows(std::string& out, const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  for (const ErrorTimeRow& row : table.rows)
    for (std::size_t m = 0; m < table.metrics.size(); ++m) {
      const ErrorMetric& metric = table.metrics[m];
      const RunTime time = row.time.value_or(RunTime());
      const auto shown = [&](double value) { return row.time ? number(value, time_digits) : ""; };
      append_csv_row(
          out, {family.id, table.id, row.id, metric.id, metric.unit, number(row.errors[m], error_digits),
                row.time ? table.time_unit : "", shown(time.median_ns), shown(time.first_quartile_ns),
                shown(time.third_quartile_ns), shown(time.ratio), std::string(name(row.verdict))});
    }
}

}  // namespace

std::string error_time_csv(const ReportHeader&, std::span<const ErrorTimeFamily> families) {
  std::string out(column_names);
  for (const ErrorTimeFamily& family : families)
    for (const ErrorTimeTable& table : family.tables) append_rows(out, family, table);
  return out;
}

std::string error_time_csv(const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  std::string out(column_names);
  append_rows(out, family, table);
  return out;
}

}  // namespace etak
