// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/alloy.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/material/f0.h"
#include "core/material/json.h"
#include "core/material/optics/optics_at.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::vector<Material> shipped_series() {
  std::vector<Material> out;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/resources/series")) {
    const std::string file = entry.path().string();
    out.push_back(parse_material(slurp(file), file));
  }
  return out;
}

LinearRgb f0_of(const Material& material) {
  static const F0Solver solver{F0Options{}};
  const F0Result result = solver.solve(material.preferred_dataset().optics);
  REQUIRE_FALSE(result.refused());
  return result.srgb_linear;
}

double farthest_channel(const LinearRgb& a, const LinearRgb& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

double at_550_nm(const Material& material, bool k) {
  const auto& constants = std::get<OpticalConstants>(material.preferred_dataset().optics);
  const std::vector<double> nm{550};
  return (k ? k_at(constants, nm, "k") : n_at(constants, nm, "n")).front();
}

std::string alloy_refusal(std::string_view text) {
  try {
    (void)library().find(text);
  } catch (const std::exception& e) {
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("33 compositions that are left out are met within 0.02 of linear F0 by their two neighbours") {
  std::size_t answered = 0, met = 0;
  double farthest = 0;
  for (const Material& series : shipped_series()) {
    REQUIRE(is_series(series));
    std::vector<std::pair<double, std::string>> order;
    for (const Dataset& each : series.datasets) order.emplace_back(std::atof(each.id.c_str()), each.id);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      Material rest = series, left_out = series;
      std::erase_if(rest.datasets, [&](const Dataset& each) { return each.id == order[i].second; });
      std::erase_if(left_out.datasets, [&](const Dataset& each) { return each.id != order[i].second; });
      left_out.preferred = 0;
      // Twice the step that is answered else, because a composition between the neighbours is missing.
      const Material guess = alloy(rest, order[i].first, series.id, 2 * widest_step);
      const double off = farthest_channel(f0_of(guess), f0_of(left_out));
      INFO(series.id << " " << order[i].second << ": " << off);
      CHECK(off < 0.02);
      farthest = std::max(farthest, off);
      ++answered;
      met += off < 0.02;
    }
  }
  CHECK(answered == 33);
  CHECK(met == answered);
  CHECK(farthest > 0.015);  // the figure of the documentation is no better than this
}

TEST_CASE("n and k lie on the line between the neighbours, and a measured composition is its dataset") {
  const Material low = material("silver_gold:0.3"), high = material("silver_gold:0.4"),
                 between = material("silver_gold:0.35");
  for (const bool k : {false, true})
    CHECK(at_550_nm(between, k) == Approx((at_550_nm(low, k) + at_550_nm(high, k)) / 2));
  CHECK(low.preferred_dataset().id == "0.3");
  CHECK(between.preferred_dataset().id == "0.3-0.4");
  CHECK(between.datasets.size() == 1);
  // Every fifth row of the same page.
  CHECK(farthest_channel(f0_of(material("silver_gold:0.5")), f0_of(material("electrum_50"))) < 2e-4);
  CHECK(f0_of(material("AlGaAs:0.2")) == f0_of(material("gallium_aluminum_arsenide:0.2")));
  CHECK(contains(library().answer("silver_gold:0.35")->note, "gold, by atoms, n and k linear between"));
}

TEST_CASE("a composition is a layer and a base of a stack") {
  const Material film = material("silver_gold:0.35:40nm/silicon_germanium:0.5");
  const auto& stack = std::get<Stack>(film.preferred_dataset().optics);
  REQUIRE(stack.layers.size() == 1);
  CHECK(stack.layers[0].thickness_nm == 40);
  CHECK(stack.media[0].id == "silver_gold_0_35");
  CHECK(stack.media[1].id == "silicon_germanium_0_5");
}

TEST_CASE("what is not measured is refused with what is") {
  CHECK(contains(alloy_refusal("gallium_aluminum_antimonide:0.7"),
                 "0.7 is outside of what is measured; expected 0 to 0.5 of aluminium"));
  CHECK(contains(alloy_refusal("silicon_germanium:0"), "expected 0.02 to 0.89 of germanium"));
  CHECK(contains(alloy_refusal("silver_gold:1.2"), "thickness 1.2 has no unit"));
  CHECK_FALSE(library().find("water:0.5"));
  CHECK(library().missing("water:0.5").found == "water is no series of compositions");
  CHECK(contains(library().missing("water:0.5").expected, "silver_gold"));
  Material wide = shipped_series().front();
  wide.datasets.resize(2);
  wide.datasets[0].id = "0.1";
  wide.datasets[1].id = "0.5";
  CHECK_THROWS_WITH(alloy(wide, 0.2, "x:0.2"),
                    Catch::Contains("0.1 and 0.5") &&
                        Catch::Contains("too far apart; expected neighbours at most 0.2 apart"));
  wide.datasets[1].id = "rich";
  CHECK_FALSE(is_series(wide));
}

TEST_CASE("a series of a folder is asked as those of etak are") {
  MaterialLibrary own = MaterialLibrary::builtin();
  Material series = shipped_series().front();
  series.id = "my_alloy";
  series.aliases.clear();
  own.add(series);
  CHECK(own.find("my_alloy:" + series.datasets[1].id));
  CHECK_FALSE(own.find("gold:0.5"));
}
