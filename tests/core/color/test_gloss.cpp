// SPDX-License-Identifier: Apache-2.0
#include "core/color/gloss.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("a given roughness keeps its own width from 0 to 1, a gloss goes no further than its ends") {
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

TEST_CASE("gloss and roughness go back and forth inside 0.149 to 0.904, and only there") {
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

TEST_CASE("Schueler's gloss ends where the exponent leaves 1 to 4096; one minus roughness has no ends") {
  const auto g = [](double r) { return converted_gloss(r, GlossForm::roughness, GlossForm::schueler); };
  // e = 2 / r^4 - 2: r = 0.5 gives 30, log2(30) / 12 = 0.40891.
  CHECK(g(0.5) == Approx(0.408907).epsilon(1e-5));
  CHECK(g(0.1485) > 1);
  CHECK(g(0.1487) < 1);
  CHECK(g(0.9035) > 0);
  CHECK(g(0.9037) < 0);
  CHECK(g(0) > 1);
  CHECK(g(1) < 0);
  for (const double r : {0.15, 0.3, 0.6, 0.9}) {
    CHECK(converted_gloss(g(r), GlossForm::schueler, GlossForm::roughness) == Approx(r));
    const double linear = converted_gloss(r, GlossForm::roughness, GlossForm::one_minus_roughness);
    CHECK(linear == Approx(1 - r));
    CHECK(converted_gloss(linear, GlossForm::one_minus_roughness, GlossForm::roughness) == Approx(r));
  }
}

TEST_CASE("an exponent and a width of one lobe stand for one gloss, in double and in float") {
  for (const double gloss : {0.0, 0.3, 0.75, 1.0}) {
    const double e = exponent_of_gloss(gloss);
    CHECK(gloss_of_exponent(e) == Approx(gloss).margin(1e-14));
    CHECK(exponent_of_alpha(alpha_of_exponent(e)) == Approx(e).epsilon(1e-12));
    CHECK(variance_of_gloss(gloss) == Approx(1 / e).epsilon(1e-14));
    CHECK(gloss_of_variance(1 / e) == Approx(gloss).margin(1e-14));
    CHECK(double{alpha_of_gloss(static_cast<float>(gloss))} == Approx(alpha_of_gloss(gloss)).epsilon(1e-5));
  }
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

TEST_CASE("what a gloss cannot hold is said in numbers") {
  CHECK(held_text(Gloss::of_roughness(0.5)).empty());
  CHECK(held_text(Gloss(0)).empty());
  CHECK(held_text(Gloss::of_roughness(0)) ==
        "Schueler's gloss holds roughness 0.149 to 0.904: gloss 1, roughness 0.149, stands for roughness 0");
  CHECK(roughness_text(Gloss(0.75)) == "roughness 0.25 (gloss 0.75)");
  CHECK(roughness_text(Gloss::of_roughness(1)) == "roughness 1");
}

TEST_CASE("a gloss is given as gloss or as roughness, once and within its range") {
  CHECK_FALSE(given_gloss(std::nullopt, std::nullopt).has_value());
  CHECK(given_gloss(0.5, std::nullopt) == Gloss(0.5));
  CHECK(given_gloss(std::nullopt, 0.05) == Gloss::of_roughness(0.05));
  CHECK_THROWS_WITH(given_gloss(0.5, 0.5), Catch::StartsWith("roughness: given beside gloss"));
  for (const double bad : {-0.1, 1.1, double{NAN}}) {
    CHECK_THROWS_WITH(given_gloss(bad, std::nullopt), Catch::StartsWith("gloss: "));
    CHECK_THROWS_WITH(given_gloss(std::nullopt, bad), Catch::StartsWith("roughness: "));
  }
}
