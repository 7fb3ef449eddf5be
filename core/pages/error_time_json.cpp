// SPDX-License-Identifier: Apache-2.0
// The JSON form of `etak report`, as resources/schema/error-time.schema.json describes it.
#include "core/base/json/json_text.h"
#include "core/pages/error_time_report.h"

namespace etak {
namespace {

std::string time_json(const RunTime& time) {
  return json_object({{"median", json(time.median_ns)},
                      {"firstQuartile", json(time.first_quartile_ns)},
                      {"thirdQuartile", json(time.third_quartile_ns)},
                      {"ratio", json(time.ratio)}},
                     -1);
}

std::string point_json(const ErrorPoint& point) {
  return json_object(
      {{"material", json(point.material)}, {"error", json(point.error)}, {"doubtful", json(point.doubtful)}},
      -1);
}

std::string row_json(const ErrorTimeRow& row) {
  return json_object({{"id", json(row.id)},
                      {"title", json(row.title)},
                      {"errors", json_array_of(row.errors)},
                      {"time", row.time ? time_json(*row.time) : "null"},
                      {"verdict", json(name(row.verdict))},
                      {"truth", json(row.truth)},
                      {"points", '[' + joined(row.points, ", ", point_json) + ']'},
                      {"note", json(row.note)}},
                     -1);
}

std::string metric_json(const ErrorMetric& metric) {
  return json_object({{"id", json(metric.id)}, {"title", json(metric.title)}, {"unit", json(metric.unit)}},
                     -1);
}

std::string table_json(const ErrorTimeTable& table) {
  return json_object({{"id", json(table.id)},
                      {"title", json(table.title)},
                      {"metrics", json_lines_of(table.metrics, 10, metric_json)},
                      {"plotted", json(table.plotted)},
                      {"timeUnit", json(table.time_unit)},
                      {"base", json(table.base)},
                      {"rows", json_lines_of(table.rows, 10, row_json)}},
                     8);
}

std::string pick_json(const ErrorTimePick& pick) {
  return json_object({{"whom", json(pick.whom)},
                      {"table", json(pick.table)},
                      {"row", json(pick.row)},
                      {"why", json(pick.why)},
                      {"command", json(pick.command)}},
                     -1);
}

std::string family_json(const ErrorTimeFamily& family) {
  const JsonMember members[] = {
      {"id", json(family.id)},
      {"letter", json(family.letter)},
      {"title", json(family.title)},
      {"reference", json(family.reference)},
      {"grid", json(family.grid)},
      {"advice", json(family.advice)},
      {"picks", json_lines_of(family.picks, 6, pick_json)},
      {"tables", json_lines_of(family.tables, 6, table_json)},
      {"notes", json_lines_of(family.notes, 6, [](const std::string& note) { return json(note); })}};
  return json_object(members, 4);
}

}  // namespace

std::string error_time_json(const ReportHeader& header, std::span<const ErrorTimeFamily> families) {
  const JsonMember about[] = {{"version", json(header.version)},
                              {"commit", json(header.commit)},
                              {"cpu", json(header.cpu)},
                              {"gpu", json(header.gpu)},
                              {"compiler", json(header.compiler)},
                              {"flags", json(header.flags)},
                              {"threads", json(std::size_t{header.threads})},
                              {"repeats", json(header.repeats)},
                              {"emptyLoopNs", json(header.empty_loop_ns)},
                              {"effort", json(header.effort)}};
  return json_document("etak-error-time/2", {{"header", json_object(about, 2)},
                                             {"families", json_lines_of(families, 2, family_json)}});
}

}  // namespace etak
