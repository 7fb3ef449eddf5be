// SPDX-License-Identifier: Apache-2.0
#include "core/color/gloss.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE(
    "found 1.06: a given roughness keeps its own width from 0 to 1, a gloss goes no further than its ends") {
  for (const double r : {0.0, 0.05, 0.1486, 0.25, 0.5, 0.9, 0.95, 1.0}) {
    const Gloss gloss = Gloss::of_roughness(r);
    CHECK(gloss.roughness() == r);
    CHECK(gloss.alpha() == r * r);
    CHECK(double{gloss} >= 0);
    CHECK(double{gloss} <= 1);
    REQUIRE(gloss.given_roughness());
    CHECK(*gloss.given_roughness() == r);
  }
  CHECK(Gloss::of_roughness(0) == 1);
  CHECK(Gloss::of_roughness(1) == 0);
  CHECK(std::isinf(Gloss::of_roughness(0).exponent()));
  CHECK(Gloss::of_roughness(1).exponent() == 0);
}

TEST_CASE("found 1.06: gloss and roughness go back and forth inside 0.149 to 0.904, and only there") {
  for (const double g : {0.0, 0.1, 0.25, 0.5, 0.75, 1.0}) {
    const double r = roughness_of_gloss(g);
    CHECK(gloss_of_roughness(r) == Approx(g).margin(1e-12));
    CHECK(Gloss(g).alpha() == Approx(r * r).epsilon(1e-14));
    // e = 2 / alpha^2 - 2.
    CHECK(Gloss(g).exponent() == Approx(2 / std::pow(r, 4) - 2).epsilon(1e-9));
    CHECK(!Gloss(g).held());
    CHECK(!Gloss(g).given_roughness());
  }
  for (const double r : {0.149, 0.25, 0.9, 0.9036}) CHECK(!Gloss::of_roughness(r).held());
  for (const double r : {0.0, 0.1, 0.1486, 0.9037, 1.0}) CHECK(Gloss::of_roughness(r).held());
}

TEST_CASE("a gloss is a number, and a number put into it forgets the roughness") {
  Gloss gloss = Gloss::of_roughness(0);
  CHECK(gloss != Gloss(1));
  gloss = 0.75;
  CHECK(gloss == Gloss(0.75));
  CHECK(gloss == 0.75);
  CHECK(gloss.alpha() == alpha_of_gloss(0.75));
  CHECK(std::isnan(double{Gloss::of_roughness(std::nan(""))}));
}

TEST_CASE("found 1.06: what a gloss cannot hold is said in numbers") {
  CHECK(held_text(Gloss::of_roughness(0.5)).empty());
  CHECK(held_text(Gloss(0)).empty());
  CHECK(held_text(Gloss::of_roughness(0)) ==
        "Schueler's gloss holds roughness 0.149 to 0.904: gloss 1, roughness 0.149, stands for roughness 0");
  CHECK(roughness_text(Gloss(0.75)) == "roughness 0.25 (gloss 0.75)");
  CHECK(roughness_text(Gloss::of_roughness(1)) == "roughness 1");
}
