// SPDX-License-Identifier: Apache-2.0
// The JSON form of `etak report`, as resources/schema/error-time.schema.json describes it.
#include "core/base/json_text.h"
#include "core/pages/error_time_report.h"

namespace etak {
namespace {

constexpr std::string_view schema_name = "etak-error-time/1";

template <class Values, class Write>
std::string lines(const Values& values, int indent, Write write) {
  if (values.empty()) return "[]";
  const std::string start = "\n" + std::string(static_cast<std::size_t>(indent) + 2, ' ');
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i) out += (i == 0 ? "" : ",") + start + write(values[i]);
  return out + "\n" + std::string(static_cast<std::size_t>(indent), ' ') + "]";
}

std::string time_json(const RunTime& time) {
  const JsonMember members[] = {{"median", json(time.median_ns)},
                                {"firstQuartile", json(time.first_quartile_ns)},
                                {"thirdQuartile", json(time.third_quartile_ns)},
                                {"ratio", json(time.ratio)}};
  return json_object(members, -1);
}

std::string row_json(const ErrorTimeRow& row) {
  const JsonMember members[] = {{"id", json(row.id)},
                                {"title", json(row.title)},
                                {"errors", json_array_of(row.errors)},
                                {"time", row.time ? time_json(*row.time) : "null"},
                                {"pareto", json(row.pareto)},
                                {"dominated", json(row.dominated)},
                                {"note", json(row.note)}};
  return json_object(members, -1);
}

std::string metric_json(const ErrorMetric& metric) {
  const JsonMember members[] = {
      {"id", json(metric.id)}, {"title", json(metric.title)}, {"unit", json(metric.unit)}};
  return json_object(members, -1);
}

std::string table_json(const ErrorTimeTable& table) {
  const JsonMember members[] = {{"id", json(table.id)},
                                {"title", json(table.title)},
                                {"metrics", lines(table.metrics, 10, metric_json)},
                                {"plotted", json(table.plotted)},
                                {"timeUnit", json(table.time_unit)},
                                {"base", json(table.base)},
                                {"rows", lines(table.rows, 10, row_json)}};
  return json_object(members, 8);
}

std::string family_json(const ErrorTimeFamily& family) {
  const JsonMember members[] = {
      {"id", json(family.id)},
      {"letter", json(family.letter)},
      {"title", json(family.title)},
      {"reference", json(family.reference)},
      {"grid", json(family.grid)},
      {"advice", json(family.advice)},
      {"tables", lines(family.tables, 6, table_json)},
      {"notes", lines(family.notes, 6, [](const std::string& note) { return json(note); })}};
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
  const JsonMember members[] = {{"schema", json(schema_name)},
                                {"header", json_object(about, 2)},
                                {"families", lines(families, 2, family_json)}};
  return json_object(members, 0) + "\n";
}

}  // namespace etak
