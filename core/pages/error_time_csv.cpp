// SPDX-License-Identifier: Apache-2.0
#include "core/base/csv.h"
#include "core/base/number.h"
#include "core/pages/error_time_report.h"

namespace etak {
namespace {

constexpr int error_digits = 9, time_digits = 4;

}  // namespace

std::string error_time_csv(const ReportHeader&, std::span<const ErrorTimeFamily> families) {
  std::string out =
      "family,table,row,metric,unit,error,time_unit,median,first_quartile,third_quartile,ratio,pareto,"
      "dominated\n";
  for (const ErrorTimeFamily& family : families)
    for (const ErrorTimeTable& table : family.tables)
      for (const ErrorTimeRow& row : table.rows)
        for (std::size_t m = 0; m < table.metrics.size(); ++m) {
          const ErrorMetric& metric = table.metrics[m];
          out += csv_field(family.id) + ',' + csv_field(table.id) + ',' + csv_field(row.id) + ',' +
                 csv_field(metric.id) + ',' + csv_field(metric.unit) + ',' +
                 number(row.errors[m], error_digits) + ',';
          if (row.time)
            out += csv_field(table.time_unit) + ',' + number(row.time->median_ns, time_digits) + ',' +
                   number(row.time->first_quartile_ns, time_digits) + ',' +
                   number(row.time->third_quartile_ns, time_digits) + ',' +
                   number(row.time->ratio, time_digits) + (row.pareto ? ",1," : ",0,") +
                   (row.dominated ? "1\n" : "0\n");
          else
            out += ",,,,,,\n";
        }
  return out;
}

}  // namespace etak
