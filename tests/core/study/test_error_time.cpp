// SPDX-License-Identifier: Apache-2.0
#include "core/pages/error_time_report.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A row whose time in each of nine rounds is the median times 1, 1 + spread, or 1 - spread, by chance.
ErrorTimeRow row(const std::string& id, double error, double median, double spread) {
  ErrorTimeRow out;
  out.id = out.title = id;
  out.errors = {error};
  RunTime time{median, median * (1 - spread), median * (1 + spread), 1, median * (1 - spread), {}};
  const int offset = static_cast<int>(id.size());
  for (int round = 0; round < 9; ++round)
    time.rounds_ns.push_back(median * (1 + spread * ((round + offset) % 3 - 1)));
  out.time = time;
  return out;
}

ErrorTimeTable table_of(std::vector<ErrorTimeRow> rows) {
  ErrorTimeTable table;
  table.id = table.title = "metals";
  table.metrics = {{"max_abs", "largest error", ""}};
  table.base = rows[0].id;
  table.rows = std::move(rows);
  set_verdicts(table);
  return table;
}

ErrorTimeFamily family() {
  ErrorTimeRow reference;
  reference.id = reference.title = "truth";
  reference.errors = {0};
  ErrorTimeFamily out;
  out.id = "fresnel";
  out.letter = "b";
  out.title = "Fresnel";
  out.advice = "Take the fast one.";
  out.picks = {{"drawing <metals>", "metals", "fast", "it is fast", "etak choose gold"}};
  out.tables = {table_of({row("fast", 0.2, 1, 0.1), row("beaten & slow", 0.3, 5, 0.1),
                          row("close call", 0.25, 0.9, 0.2), row("exact", 0, 20, 0.05), reference})};
  return out;
}

}  // namespace

TEST_CASE("a verdict is given where the rounds settle it, and withheld where they do not") {
  const auto rows = family().tables[0].rows;
  CHECK(rows[0].verdict == Verdict::unbeaten);
  CHECK(rows[1].verdict == Verdict::beaten);
  CHECK(rows[2].verdict == Verdict::not_settled);
  CHECK(rows[3].verdict == Verdict::unbeaten);
  CHECK(rows[4].verdict == Verdict::not_timed);
  // Those that are open are repeated: the row, and what it has to be told from.
  CHECK(open_rows(family().tables[0]) == std::vector<bool>{true, false, true, false, false});
}

TEST_CASE("ways that run the same instructions are told apart by their errors alone") {
  // Times within a tenth are equal, in either order: chance cannot make a front of them.
  for (const double time : {0.97, 1.0, 1.03}) {
    const auto rows = table_of({row("a", 0.1, 1, 0.01), row("b", 0.2, time, 0.01)}).rows;
    CHECK(rows[0].verdict == Verdict::unbeaten);
    CHECK(rows[1].verdict == Verdict::beaten);
  }
  // A tenth of the time is worth an error, less is not.
  CHECK(table_of({row("a", 0.1, 1, 0.01), row("b", 0.2, 0.8, 0.01)}).rows[1].verdict == Verdict::unbeaten);
  CHECK(table_of({row("a", 0.1, 1, 0.01), row("b", 0.2, 0.91, 0.01)}).rows[1].verdict ==
        Verdict::not_settled);
  // As close: the faster one beats the other, and as fast none does.
  const auto equal =
      table_of({row("a", 0.1, 1, 0.01), row("b", 0.1, 1.02, 0.01), row("c", 0.1, 2, 0.01)}).rows;
  CHECK(equal[0].verdict == Verdict::unbeaten);
  CHECK(equal[1].verdict == Verdict::unbeaten);
  CHECK(equal[2].verdict == Verdict::beaten);
}

TEST_CASE("what slows a whole round down does not open a verdict, and one bad round does not change it") {
  auto rows = table_of({row("a", 0.1, 1, 0.02), row("bb", 0.2, 0.7, 0.02)}).rows;
  for (std::size_t round = 0; round < 9; ++round)
    for (ErrorTimeRow& each : rows) each.time->rounds_ns[round] *= 1 + static_cast<double>(round % 4);
  CHECK(table_of(rows).rows[1].verdict == Verdict::unbeaten);
  rows[1].time->rounds_ns[4] *= 10;
  CHECK(table_of(rows).rows[1].verdict == Verdict::unbeaten);
  // A round of one of them alone says nothing.
  rows[0].time->rounds_ns[3] = std::nan("");
  CHECK(table_of(rows).rows[1].verdict == Verdict::unbeaten);
}

TEST_CASE("what to pick is beaten by no other way to the same truth, whatever the times are") {
  // A pick that a closer way beats gives way to it, one that is not beaten stays.
  auto one = family();
  one.picks[0].row = "beaten & slow";
  settle_picks(one);
  CHECK(one.picks[0].row == "fast");
  CHECK(one.picks[0].why == "on this machine closer than \"beaten & slow\" for at most a tenth more time");
  CHECK(one.picks[0].command.empty());
  auto other = family();
  settle_picks(other);
  CHECK(other.picks[0].row == "fast");
  CHECK(other.picks[0].why == "it is fast");
  CHECK(other.picks[0].command == "etak choose gold");
  // As a property: of any errors and times, of one truth or two, no pick is beaten afterwards.
  SplitMix random(20);
  int replaced = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<ErrorTimeRow> rows;
    const auto count = 2 + static_cast<std::size_t>(random.uniform(0, 8));
    for (std::size_t i = 0; i < count; ++i) {
      // Few different errors, so that some are equal.
      rows.push_back(
          row(std::to_string(i), 0.1 * std::floor(random.uniform(0, 4)), random.uniform(0.5, 2), 0.02));
      rows.back().truth = random.uniform() < 0.3 ? "another" : "";
    }
    auto each = family();
    each.tables = {table_of(rows)};
    each.picks.clear();
    for (std::size_t i = 0; i < count; ++i)
      each.picks.push_back({"all", "metals", std::to_string(i), "", "x"});
    settle_picks(each);
    REQUIRE(each.picks.size() == count);
    const auto& judged = each.tables[0].rows;
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(std::stoi(each.picks[i].row));
      CHECK(judged[at].verdict != Verdict::beaten);
      CHECK(judged[at].truth == judged[i].truth);
      CHECK((at == i) == (judged[i].verdict != Verdict::beaten));
      replaced += at != i;
    }
  }
  CHECK(replaced > 100);
}

TEST_CASE("a ratio is the median over the rounds that a way and the table's base were both part of") {
  auto rows = table_of({row("a", 0.1, 2, 0), row("b", 0.1, 3, 0)}).rows;
  rows[0].time->rounds_ns = {2, 2, 2, std::nan("")};
  rows[1].time->rounds_ns = {3, 4, 100, 1};
  ErrorTimeTable table;
  table.base = "a";
  table.rows = rows;
  set_ratios(table);
  CHECK(table.rows[0].time->ratio == 1);
  CHECK(table.rows[1].time->ratio == 2);
}

TEST_CASE("few rounds settle less than many that differ as much") {
  auto rows = table_of({row("a", 0.1, 1, 0), row("bb", 0.2, 0.8, 0.05)}).rows;
  CHECK(table_of(rows).rows[1].verdict == Verdict::unbeaten);
  for (ErrorTimeRow& each : rows) each.time->rounds_ns.resize(3);
  CHECK(table_of(rows).rows[1].verdict == Verdict::not_settled);
}

TEST_CASE("only ways to the same truth are compared, and a truth with one way has no front") {
  std::vector<ErrorTimeRow> rows{row("ggx", 0.1, 1, 0.01), row("ggx slow", 0.2, 2, 0.01),
                                 row("phong", 1e-9, 0.1, 0.01)};
  rows[0].truth = rows[1].truth = "GGX";
  rows[2].truth = "Phong";
  const ErrorTimeTable table = table_of(rows);
  CHECK(table.rows[0].verdict == Verdict::unbeaten);
  CHECK(table.rows[1].verdict == Verdict::beaten);
  CHECK(table.rows[2].verdict == Verdict::alone);
  // One unbeaten way of a truth makes no line, and two of different truths are not joined.
  CHECK(!contains(error_time_svg(family(), table), "class=\"front\""));
}

TEST_CASE("the overview names what to pick, its error and cost, and leads to figure and command") {
  const std::string page = error_time_page({}, std::vector{family()});
  const auto overview =
      page.substr(page.find("id=\"overview\""), page.find("id=\"fresnel\"") - page.find("id=\"overview\""));
  for (const char* part : {"drawing &lt;metals&gt;", "<b>fast</b>", "it is fast", "0.2<small>largest error",
                           "href=\"#fresnel-metals\"", "<code>etak choose gold</code>",
                           "3 of 4 timed ways have a settled verdict, 1 has not"}) {
    INFO(part);
    CHECK(contains(overview, part));
  }
  CHECK(contains(page, "<figure id=\"fresnel-metals\">"));
  CHECK(page.find("id=\"overview\"") < page.find("<article id=\"fresnel\""));
  // Tables can be read without a script: no row is hidden, every table has a caption.
  CHECK(!contains(page, "<tr hidden"));
}

TEST_CASE(
    "every dot has its number on it, names stand right beside their dots, and crosses show doubtful data") {
  auto one = family();
  ErrorTimeTable& table = one.tables[0];
  table.rows[0].points = {{"gold", 0.1, false}, {"zinc", 0.4, true}};
  const std::string svg = error_time_svg(one, table);
  for (const char* number : {">1</text>", ">2</text>", ">3</text>", ">4</text>"})
    CHECK(contains(svg, number));
  CHECK(!contains(svg, ">5</text>"));  // not timed
  CHECK(!contains(svg, "leader"));
  CHECK(contains(svg, "class=\"one\""));
  CHECK(contains(svg, "class=\"doubtful\""));
  const std::string file = error_time_svg_file(one, table);
  CHECK(contains(file, "<style>"));
  CHECK(!contains(file, "var(--"));
  CHECK(contains(file, "5  truth (not timed)"));
}

TEST_CASE("each figure has a link of its own and its CSV") {
  const auto one = family();
  const std::string page = error_time_page({}, std::vector{one});
  CHECK(contains(page, "<a href=\"#fresnel-metals\">link</a>"));
  CHECK(contains(page, "<a href=\"fresnel-metals.csv\">csv</a>"));
  CHECK(contains(page, "<a href=\"fresnel-metals.svg\">svg</a>"));
  CHECK(error_time_csv(one, one.tables[0]) == error_time_csv({}, std::vector{one}));
  auto two = one;
  two.tables.push_back(one.tables[0]);
  two.tables[1].id = "others";
  CHECK(!contains(error_time_csv(two, two.tables[0]), "others"));
}

TEST_CASE("the page says what a settled verdict covers") {
  CHECK(contains(error_time_page({}, std::vector{family()}), "on this machine and with this build"));
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
                 "fresnel,metals,fast,max_abs,,0.2,ns per evaluation,1,0.9,1.1,1,unbeaten"));
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
