// SPDX-License-Identifier: Apache-2.0
// The printed rows of the three sources beside etak's values.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/base/text/ascii.h"
#include "core/material/f0.h"
#include "core/pages/lists/sources.h"
#include "tests/support.h"

using namespace etak;

namespace {

const std::vector<SourceRow>& rows() {
  static const std::vector<SourceRow> out = source_rows(MaterialLibrary::builtin());
  return out;
}

const SourceRow& row_of(std::string_view source, std::string_view name) {
  return *std::ranges::find_if(rows(),
                               [&](const SourceRow& r) { return r.source == source && r.row == name; });
}

}  // namespace

TEST_CASE("where the data of a print are open, its three decimals and its codes come out") {
  std::set<std::string> same;
  for (const SourceRow& row : rows()) {
    if (row.source != "Hoffman" || !row.reason.starts_with("the same data")) continue;
    INFO(row.row);
    CHECK(row.difference() < 7e-4);
    CHECK(row.codes == row.printed_codes);
    same.insert(row.row);
  }
  CHECK(same == std::set<std::string>{"Aluminum", "Chromium", "Copper", "Crystalline silicon", "Gold",
                                      "Palladium", "Silver"});
}

TEST_CASE("every F0 that Hoffman and Schueler print is a row, with its number and its code") {
  const auto printed = test::read_csv(test::source_folder() + "/tests/data/seed_tables.csv");
  REQUIRE(printed.size() == 59);
  for (std::size_t i = 1; i < printed.size(); ++i) {
    const std::string name = lower_case(printed[i][1].substr(0, printed[i][1].find(" (")));
    const double value = test::to_number(printed[i][3]), code = test::to_number(printed[i][4]);
    INFO(printed[i][0] << ", " << name << ' ' << value << ' ' << code);
    CHECK(std::ranges::any_of(rows(), [&](const SourceRow& row) {
      return row.source == printed[i][0] && lower_case(row.row).starts_with(name) &&
             std::ranges::count(row.printed, value) > 0 && std::ranges::count(row.printed_codes, code) > 0;
    }));
  }
}

TEST_CASE("of a metal whose printed data are not open the row shows the nearest dataset") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  for (const char* id : {"titanium", "iron", "nickel", "platinum", "zinc"}) {
    const SourceRow& row = *std::ranges::find_if(
        rows(), [&](const SourceRow& r) { return r.by.starts_with("f0 " + std::string(id) + "/"); });
    const Material material = *library.find(id);
    std::string nearest;
    double least = 1;
    for (const Dataset& dataset : material.datasets) {
      const F0Result f0 = F0Solver({}).solve(dataset.optics);
      if (f0.refused()) continue;
      double worst = 0;
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(vec(f0.linear)[c] - row.printed[c]));
      if (worst < least) nearest = dataset.id;
      least = std::min(least, worst);
    }
    CHECK(row.by == "f0 " + std::string(id) + "/" + nearest);
  }
}

TEST_CASE("each row that differs from its print says why, and what is wrong in print is named") {
  for (const SourceRow& row : rows()) {
    INFO(row.source << " " << row.row);
    CHECK(!row.reason.empty());
    CHECK(row.value.empty() == row.by.empty());
  }
  CHECK(row_of("Hoffman", "Diamond-like, low end").codes == std::vector{89});
  CHECK(row_of("Hoffman", "Diamond-like, high end").codes == std::vector{124});
  CHECK(row_of("Schueler", "Water").codes == std::vector{44});
  CHECK(row_of("TU Graz", "Beckmann as printed gives").value[0] ==
        Approx(3.14159265358979 / 4).epsilon(1e-9));
  CHECK(row_of("Hoffman", "GGX at alpha 1 gives back").value[0] == Approx(1 - 0.69).margin(0.005));
  CHECK(row_of("Schueler", "Contrast of 8 bits").value[0] == Approx(196965).margin(1));
  CHECK(row_of("Schueler", "Contrast of 8 bits, the sRGB curve").value[0] == Approx(3294.6).margin(0.1));
}

TEST_CASE("a difference is that of the worst number, and there is none where one is missing") {
  SourceRow row;
  row.printed = {0.5, 0.25};
  row.value = {0.5, 0.5};
  CHECK(row.difference() == 0.25);
  row.value.pop_back();
  CHECK(std::isnan(row.difference()));
}
