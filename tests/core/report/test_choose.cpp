// SPDX-License-Identifier: Apache-2.0
#include "core/report/choose.h"

#include <catch2/catch.hpp>

#include "core/base/error.h"
#include "core/material/library.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Choice chosen(const std::string& id, double budget = 1) {
  const auto material = MaterialLibrary::builtin().find(id);
  REQUIRE(material);
  return choose(*material, material->preferred_dataset(), budget, 0.75, shipped_costs());
}

}  // namespace

TEST_CASE("silver needs no more than Schlick, coloured metals F82, semiconductors and chromium n and k") {
  CHECK(chosen("silver").fresnel->id == "schlick");
  for (const auto* id : {"gold", "copper", "aluminum"}) {
    INFO(id);
    CHECK(std::string(chosen(id).fresnel->id).starts_with("f82"));
  }
  CHECK(chosen("chromium").fresnel->id == "index");
  // Silicon's k is so small in the visible that n alone does.
  CHECK(chosen("silicon").fresnel->id == "from_f0");
  CHECK(chosen("germanium").fresnel->id == "index");
}

TEST_CASE("dielectrics are exact from F0 alone") {
  for (const auto* id : {"water", "glass_bk7", "diamond", "polystyrene", "halite"}) {
    INFO(id);
    CHECK(chosen(id).fresnel->id == "from_f0");
  }
}

TEST_CASE("the budget holds at every angle, in every pixel and for F0") {
  for (const auto* id : {"silver", "copper", "water"})
    for (const double budget : {0.3, 1.0, 3.0}) {
      INFO(id << " " << budget);
      const Choice choice = chosen(id, budget);
      CHECK(choice.fresnel_error <= budget);
      CHECK(choice.picture_error <= budget);
      CHECK(choice.method_error <= budget);
      CHECK(choice.chosen_ns <= choice.everything_ns * 1.1);
    }
}

TEST_CASE("a smaller budget never takes a cheaper form") {
  double before = 0;
  for (const double budget : {8.0, 3.0, 1.0, 0.5}) {
    const double cost = chosen("titanium", budget).chosen_ns;
    CHECK(cost >= before * 0.9);
    before = cost;
  }
}

TEST_CASE("a budget that nothing meets, and a material without n and k, are errors") {
  CHECK_THROWS_AS(chosen("gold", 1e-6), Error);
  CHECK_THROWS_AS(chosen("brick"), Error);
}

TEST_CASE("a cost table reads back, and says what is wrong with it") {
  CHECK(parse_costs(format_costs(shipped_costs()), "c").ns.size() == shipped_costs().ns.size());
  CHECK_THROWS_WITH(parse_costs("{\"schema\": \"etak-costs/1\", \"header\": \"\", \"ns\": {\"a\": -1}}", "c"),
                    Catch::Contains("c#/ns/a"));
}
