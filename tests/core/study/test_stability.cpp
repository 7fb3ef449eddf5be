// SPDX-License-Identifier: Apache-2.0
#include "core/pages/stability_report.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/srgb.h"
#include "core/study/stability/stability_rows.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::vector<StabilityCase>& cases() {
  static const auto all = stability_cases();
  return all;
}

const StabilityCase& case_named(const std::string& id) {
  for (const auto& one : cases())
    if (one.id == id) return one;
  FAIL("no case " << id);
  return cases()[0];
}

}  // namespace

TEST_CASE("every stiff and extreme case comes out as expected") {
  REQUIRE(cases().size() >= 91);
  for (const auto& one : cases()) {
    INFO(one.id << ": " << one.found);
    CHECK(one.passed);
  }
}

// What a change for the worse would do to the report: the usual formulas are the mutants.
TEST_CASE("the textbook conductor Fresnel would turn the report red") {
  for (const auto* id :
       {"f0_near_1_1_001", "f0_near_1_1_0003", "f0_near_1_1_0001", "gas_oblique", "nothing_grazing"}) {
    INFO(id);
    CHECK(!case_named(id).naive_f32->passed);
  }
  CHECK(!case_named("total").naive_f64->passed);
}

TEST_CASE("products of characteristic matrices would turn the report red") {
  for (const auto* id : {"film_opaque", "film_opaque_float", "film_matched", "film_gas", "film_total"}) {
    INFO(id);
    CHECK(!case_named(id).naive_f32->passed);
  }
  for (const auto* id : {"film_opaque_double", "film_matched"}) CHECK(!case_named(id).naive_f64->passed);
}

TEST_CASE("other shortcuts would turn the report red too") {
  for (const auto* id :
       {"ggx_1e_3", "ggx_1e_4", "lobe_4096", "negative_k", "cosine_below_0", "optimized_peak",
        "hemisphere_step", "beckmann_horizon", "gold_red", "smith_grazing"}) {
    INFO(id);
    CHECK(!case_named(id).naive_f32->passed);
  }
}

TEST_CASE("the lecture's Beckmann constant and truncated codes would turn the report red") {
  CHECK(case_named("beckmann_integral").passed);
  CHECK(contains(case_named("beckmann_integral").found, "printed form 0.785"));
  CHECK(contains(case_named("rounding").found, "truncated"));
  std::string found;
  CHECK(counts_every_facet_once("integral_D_beckmann", found));
  CHECK(!counts_every_facet_once("integral_D_beckmann_printed", found));
  CHECK(gives_every_code_back([](double linear) { return srgb_u8(linear); }, found));
  CHECK(!gives_every_code_back(
      [](double linear) { return static_cast<std::uint8_t>(255 * srgb_encode(linear)); }, found));
}

TEST_CASE("a case that GL gets wrong fails, and text and JSON say so") {
  const auto wrong = stability_cases([](std::string_view) { return 42.0; });
  CHECK(!all_passed(wrong));
  CHECK(contains(stability_text(wrong), "FAILED"));
  CHECK(contains(stability_json(wrong), "\"passed\": false"));
  CHECK(contains(stability_text(cases()), "PASSED"));
}

TEST_CASE("cases in which the usual formula fails come first, the others are folded") {
  const std::string brief = stability_text(cases()), all = stability_text(cases(), true),
                    page = stability_html(cases());
  std::size_t shown = 0, folded = 0;
  for (const auto& one : cases()) {
    INFO(one.id);
    const std::string line = "ok    " + one.title + " (" + one.input + ")";
    CHECK(contains(all, line));
    CHECK(contains(brief, line) == usual_fails(one));
    (usual_fails(one) ? shown : folded) += 1;
    CHECK(usual_fails(one) == (one.naive_f64 && (!one.naive_f64->passed || !one.naive_f32->passed)));
  }
  CHECK(shown >= 20);
  CHECK(contains(brief, std::to_string(folded) + " more cases come out as expected"));
  CHECK(10 * brief.size() < 7 * all.size());
  CHECK(contains(page, "<details><summary>" + std::to_string(folded) + " more cases"));
  // A case that fails is never folded.
  const auto wrong = stability_cases([](std::string_view) { return 42.0; });
  CHECK(stability_text(wrong).starts_with("FAIL  "));
}
