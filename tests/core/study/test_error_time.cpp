// SPDX-License-Identifier: Apache-2.0
#include "core/pages/error_time_report.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ErrorTimeRow row(const std::string& id, double error, double median, double spread) {
  ErrorTimeRow out;
  out.id = out.title = id;
  out.errors = {error};
  out.time = RunTime{median, median - spread, median + spread, 1};
  return out;
}

ErrorTimeFamily family() {
  ErrorTimeTable table;
  table.id = table.title = "metals";
  table.metrics = {{"max_abs", "largest error", ""}};
  table.base = "fast";
  table.rows = {row("fast", 0.2, 1, 0.1), row("beaten & slow", 0.3, 5, 0.1),
                row("close call", 0.25, 1.05, 0.2), row("exact", 0, 20, 1)};
  ErrorTimeRow reference;
  reference.id = reference.title = "truth";
  reference.errors = {0};
  table.rows.push_back(reference);
  mark_dominated(table);
  ErrorTimeFamily out;
  out.id = "fresnel";
  out.letter = "b";
  out.title = "Fresnel";
  out.advice = "Take the fast one.";
  out.tables = {table};
  return out;
}

}  // namespace

TEST_CASE("a point is beaten only beyond both quartile ranges") {
  const auto rows = family().tables[0].rows;
  CHECK(rows[0].pareto);
  CHECK(rows[1].dominated);
  CHECK(!rows[1].pareto);
  CHECK(!rows[2].dominated);
  CHECK(!rows[2].pareto);
  CHECK(rows[3].pareto);
  CHECK(!rows[4].pareto);
  CHECK(!rows[4].dominated);
}

TEST_CASE("equal values give equal bytes in every form, and names are escaped") {
  const std::vector<ErrorTimeFamily> families{family()};
  const ReportHeader header{"1", "abc", "cpu", "", "gcc", "-O3", 2, 31, 0.3, "quick"};
  for (const auto form : {error_time_json, error_time_csv})
    CHECK(form(header, families) == form(header, families));
  CHECK(error_time_page(header, families) == error_time_page(header, families));
  CHECK(contains(error_time_page(header, families), "beaten &amp; slow"));
  CHECK(!contains(error_time_page(header, families), "http-equiv"));
  CHECK(contains(error_time_csv(header, families),
                 "fresnel,metals,fast,max_abs,,0.2,ns per evaluation,1,0.9,1.1,1,1,0"));
  CHECK(contains(error_time_json(header, families), "\"time\": null"));
}

TEST_CASE("every timed row is a point of the scatter, an error of nothing on the axis") {
  const auto one = family();
  const std::string svg = error_time_svg(one, one.tables[0]);
  std::size_t circles = 0;
  for (std::size_t at = 0; (at = svg.find("<circle", at)) != svg.npos; ++at) ++circles;
  CHECK(circles == 4);
  CHECK(contains(svg, "none: on the axis"));
  ErrorTimeTable untimed;
  CHECK(error_time_svg(one, untimed).empty());
}
