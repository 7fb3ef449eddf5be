// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/exchange/rii/rii_page.h"
#include "core/exchange/table.h"
#include "core/material/json.h"
#include "core/material/optics/medium.h"
#include "tests/core/material/f0_support.h"

using namespace etak;
using namespace etak::test;

namespace {

// n and k the same at both ends of the visible range.
OpticalConstants constant(double n, double k) {
  return {Spectrum{{360, 830}, {n, n}}, Spectrum{{360, 830}, {k, k}}};
}

}  // namespace

TEST_CASE("a metal without loss is white, at normal incidence and at 1/7") {
  for (const double k : {1e-6, 1.0, 5.0, 1e6})
    for (const double n : {0.0, 1e-300, 1e-30}) {
      INFO("n " << n << " k " << k);
      const F0Result got = solve(constant(n, k));
      REQUIRE(!got.refused());
      CHECK(worst_channel(got.linear, {1, 1, 1}) <= 1e-12);
      REQUIRE(got.f82);
      CHECK(worst_channel(*got.f82, {1, 1, 1}) <= 1e-12);
    }
  CHECK(contains(solve(constant(0, 0)).refusal, "n = 0 at 360 nm; n must be above 0, or 0 with k above 0"));
  CHECK(contains(solve(constant(-1, 5)).refusal, "n = -1"));
}

TEST_CASE("rows with n = 0 are read where k is above 0, whoever wrote them") {
  const Table table = parse_table("wavelength_nm,n,k\n400,0,3\n700,0.1,4\n", "t.csv", {});
  CHECK(!no_medium_at(std::get<OpticalConstants>(table.optics)));
  RiiPage page;
  parse_rii_page("DATA:\n  - type: tabulated nk\n    data: |\n        0.36 0 3\n        0.83 0 5\n", "a.yml",
                 page);
  CHECK(page.refusal.empty());
  CHECK(page.flags.none());
  parse_rii_page("DATA:\n  - type: tabulated nk\n    data: |\n        0.36 0 0\n        0.83 0 5\n", "a.yml",
                 page);
  CHECK(contains(page.refusal, "n = 0 at 360 nm"));

  // As a material the page keeps its rows, and is written and read back.
  const std::string lossless =
      "REFERENCES: x\nDATA:\n  - type: tabulated nk\n    data: |\n        0.40 0. 351e-3\n";
  const Material material = material_from_rii_page(lossless, "main/X - x/nk/Author.yml", "x");
  CHECK(parse_material(format_material(material), "written") == material);

  OpticalConstants optics{Spectrum{{400, 500, 600}, {1, 0, 0}}, Spectrum{{400, 450, 550}, {0, 0, 2}}};
  CHECK(!no_medium_at(optics));  // k is 1 at 500 nm, on the line between its own rows
  optics.k = Spectrum{{550, 600}, {0, 2}};
  CHECK(no_medium_at(optics) == 500.0);
  optics.k.reset();
  CHECK(no_medium_at(optics) == 500.0);
}
