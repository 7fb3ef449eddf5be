// SPDX-License-Identifier: Apache-2.0
#include "core/pages/f0/film.h"

#include <catch2/catch.hpp>

#include "core/color/srgb.h"
#include "core/material/find.h"
#include "core/pages/f0/report.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const Material& swept_film() {
  static const Material out = find_material(library(), "water:1mm/anatase:40nm/titanium")->answer.material;
  return out;
}

const Stack& swept_stack() {
  return std::get<Stack>(swept_film().preferred_dataset().optics);
}

std::string sweep_refusal(const std::string& text) {
  return error_of([&] { (void)film_sweep(swept_stack(), text); });
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++out;
  return out;
}

}  // namespace

TEST_CASE("a sweep over thickness names its layer from the outside, in units that may differ") {
  const FilmSweep sweep = film_sweep(swept_stack(), "2=0nm:0.4um:81");
  CHECK(sweep.layer == 2);
  REQUIRE(sweep.thickness_nm.size() == 81);
  CHECK(sweep.thickness_nm[0] == 0);
  CHECK(sweep.thickness_nm[3] == 15);
  CHECK(sweep.thickness_nm[80] == 400);
  CHECK(film_sweep(swept_stack(), "1=20nm,1.5um,2mm").thickness_nm == std::vector<double>{20, 1500, 2e6});
  CHECK(contains(sweep_refusal("3=0nm:400nm:81"), "has no layer 3; expected a layer from 1 to 2"));
  CHECK(contains(sweep_refusal("0=0nm:400nm:81"), "has no layer 0"));
  CHECK(contains(sweep_refusal("one=0nm:400nm:81"), "one; expected the number of a layer"));
  for (const char* bad :
       {"2=0:400:81", "2=0nm:400nm:1", "2=-5nm:400nm:81", "2=0nm:infnm:81", "2=5nm", "2=5nm,6", ""})
    CHECK(contains(sweep_refusal(bad), "LAYER=FIRST:LAST:COUNT"));
}

TEST_CASE("each row of a sweep is the stack that its text names") {
  const FilmSweep sweep = film_sweep(swept_stack(), "2=20nm,60nm,12um");
  const F0Solver solver({});
  const std::vector<F0Row> rows = film_rows(sweep, solver, swept_film(), swept_film().preferred_dataset());
  REQUIRE(rows.size() == 3);
  CHECK(rows[1].path == "water:1mm/anatase:60nm/titanium");
  CHECK(rows[2].path == "water:1mm/anatase:12000nm:coherent/titanium");
  for (const F0Row& row : rows) {
    const Material alone = find_material(library(), row.path)->answer.material;
    CHECK(row.result.linear == solver.solve(alone.preferred_dataset().optics).linear);
  }
  CHECK(rows[1].layers[1].thickness_nm == 60);
  CHECK_FALSE(rows[1].layers[2].thickness_nm);
  const std::string csv = film_csv(sweep, rows);
  CHECK(csv.starts_with("thickness_nm,path,"));
  CHECK(contains(csv, "\n60,water:1mm/anatase:60nm/titanium,"));
}

TEST_CASE(
    "the strip's first row has the colours of normal incidence, and its cells are every thickness and angle") {
  const FilmSweep sweep = film_sweep(swept_stack(), "2=20nm,60nm,90nm");
  const F0Options options;
  const std::string svg = film_strip(sweep, options);
  CHECK(occurrences(svg, "<rect") == 1 + 3 * 18);
  for (const F0Row& row : film_rows(sweep, F0Solver(options), swept_film(), swept_film().preferred_dataset()))
    CHECK(contains(svg, hex(row.result.srgb8)));
  CHECK(contains(svg, "</svg>"));
}
