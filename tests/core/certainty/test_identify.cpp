// SPDX-License-Identifier: Apache-2.0
#include "core/certainty/identify.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "core/base/parallel.h"
#include "core/certainty/publications.h"
#include "core/color/srgb.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const F0Solver& solver() {
  static const F0Solver out{F0Options{}};
  return out;
}

const Identifier& all_hypotheses() {
  static const Identifier out(library(), solver(), {}, 2);
  return out;
}

std::size_t rank_of(const Identified& answer, const std::string& id) {
  std::size_t out = 0;
  while (out < answer.candidates.size() && answer.candidates[out].entry->id != id) ++out;
  return out;
}

// The answer to a publication of a material with a band, which was left out and asked for.
struct LeftOut {
  std::size_t rank, length;
  double first_p;
};

// Every publication of every material that has a band and two or more of them.
std::vector<LeftOut> all_left_out() {
  std::vector<LeftOut> out;
  Identifier identifier = all_hypotheses();
  for (std::size_t i = 0; i < library().ids().size(); ++i) {
    const Material whole = library().at(i);
    const Dataset& stated = whole.preferred_dataset();
    const F0Result f0 = solver().solve(stated.optics);
    const MaterialBand band = material_band(solver(), whole, stated, f0);
    if (!band.band || band.band->publications < 2) continue;
    std::vector<const Dataset*> publications{&stated};
    for (const Publication& each : band.publications)
      if (each.left_out.empty()) publications.push_back(each.dataset);
    for (const Dataset* each : publications) {
      identifier.replace(whole.id, without_publication(whole, *each), solver());
      const Identified answer = identifier.identify({solver().solve(each->optics).srgb_linear, {}, false});
      out.push_back({rank_of(answer, whole.id), answer.candidates.size(), answer.candidates.front().p});
    }
    identifier.replace(whole.id, whole, solver());
  }
  return out;
}

}  // namespace

TEST_CASE("left-out publications are found under their names as often as the probabilities say") {
  const std::vector<LeftOut> all = all_left_out();
  REQUIRE(all.size() >= 150);
  std::size_t listed = 0, in_three = 0, sure = 0, sure_right = 0;
  std::vector<std::size_t> lengths;
  for (const LeftOut& each : all) {
    listed += each.rank < each.length ? 1 : 0;
    in_three += each.rank < 3 ? 1 : 0;
    lengths.push_back(each.length);
    if (each.first_p < sure_probability) continue;
    ++sure;
    sure_right += each.rank == 0 ? 1 : 0;
  }
  std::sort(lengths.begin(), lengths.end());
  const double count = double(all.size());
  INFO(all.size() << " left-out publications: " << listed << " in the list, " << in_three
                  << " in the first three, " << sure << " sure, " << sure_right
                  << " of them right; median length " << lengths[lengths.size() / 2]);
  CHECK(double(listed) / count >= 0.88);
  CHECK(double(listed) / count <= 0.97);
  CHECK(lengths[lengths.size() / 2] <= 7);
  CHECK(double(in_three) / count >= 0.78);
  CHECK(double(sure) / count >= 0.1);
  CHECK(double(sure_right) / double(sure) >= 0.92);
}

TEST_CASE("random colours of saturation one half and more with all channels in the zone are no material") {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> channel(0.2, 0.45);
  std::size_t none = 0, asked = 0;
  while (asked < 1000) {
    const LinearRgb colour{channel(random), channel(random), channel(random)};
    const auto [least, most] = std::minmax({colour.r, colour.g, colour.b});
    if (least > most / 2) continue;
    ++asked;
    none += all_hypotheses().identify({colour, {}, false}).verdict == ColourVerdict::none ? 1 : 0;
  }
  INFO(none << " of 1000 are no material");
  CHECK(none >= 950);
}

TEST_CASE("a material is found by its own colour, and its F82 makes that surer") {
  const F0Result copper = solver().solve(material("copper").preferred_dataset().optics);
  const Identified plain = all_hypotheses().identify({copper.srgb_linear, {}, false});
  CHECK(rank_of(plain, "copper") == 0);
  CHECK(plain.verdict != ColourVerdict::none);
  const Identified with = all_hypotheses().identify({copper.srgb_linear, copper.f82, false});
  CHECK(rank_of(with, "copper") == 0);
  CHECK(with.candidates.front().p > plain.candidates.front().p);
}

TEST_CASE("probabilities come best first, hold nine tenths and are at least three") {
  const Identified answer = all_hypotheses().identify({{0.045, 0.046, 0.047}, {}, true});
  REQUIRE(answer.candidates.size() >= 3);
  double sum = 0;
  for (std::size_t i = 0; i < answer.candidates.size(); ++i) {
    if (i > 0) CHECK(answer.candidates[i].p <= answer.candidates[i - 1].p);
    if (i >= 3) CHECK(sum < 0.9);
    sum += answer.candidates[i].p;
  }
  CHECK(sum >= 0.9);
  for (const auto& group : answer.groups) CHECK(group.size() >= 2);
}

TEST_CASE("a prior moves the answer, and a weight of 0 takes a material out") {
  const LinearRgb gold = solver().solve(material("gold").preferred_dataset().optics).srgb_linear;
  const Prior prior = parse_prior("id,weight\ngold,0\nAg,5\n", "p.csv", library());
  CHECK(prior.at("silver") == 5);
  const Identified answer = all_hypotheses().identify({gold, {}, false}, prior);
  CHECK(rank_of(answer, "gold") == answer.candidates.size());
  CHECK(contains(error_of([] { (void)parse_prior("id,weight\n", "p.csv", library()); }), "p.csv"));
  CHECK(contains(error_of([] { (void)parse_prior("id,weight\nunobtainium,1\n", "p.csv", library()); }),
                 "p.csv:2"));
  CHECK(contains(error_of([] { (void)parse_prior("id,weight\ngold,-1\n", "p.csv", library()); }), "p.csv:2"));
  CHECK(contains(error_of([] { (void)parse_prior("gold,1\n", "p.csv", library()); }), "id,weight"));
}

TEST_CASE("colours outside of [0, 1.1] are refused") {
  CHECK(contains(error_of([] { check_asked({{1.2, 0, 0}, {}, false}, "x"); }), "0 to 1.1"));
  CHECK(contains(error_of([] { check_asked({{-0.1, 0, 0}, {}, false}, "x"); }), "0 to 1.1"));
  CHECK(contains(error_of([] { check_asked({{0, 0, 0}, LinearRgb{0, 2, 0}, false}, "x"); }), "0 to 1.1"));
}

TEST_CASE("without its preferred publication a material states the one that is nearest to the others") {
  const Material titanium = material("titanium");
  const auto without = without_publication(titanium, titanium.preferred_dataset());
  REQUIRE(without);
  CHECK(without->datasets.size() == titanium.datasets.size() - 1);
  CHECK(without->preferred_dataset().id != titanium.preferred_dataset().id);
  const Material one = material("boron");
  CHECK_FALSE(without_publication(one, one.preferred_dataset()));
}
