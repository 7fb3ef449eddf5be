// SPDX-License-Identifier: Apache-2.0
#include "core/material/find.h"

#include <catch2/catch.hpp>

#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

NameWords words_at(std::string_view place, std::string_view instead = {}) {
  NameWords out;
  out.place = place;
  out.instead = instead;
  return out;
}

OutsideMedium medium(std::string_view text) {
  return outside_medium(library(), text, "place", words_at("place"));
}

}  // namespace

TEST_CASE("a material is found by id, alias and formula, and before a '/' with its dataset behind it") {
  const auto plain = find_material(library(), "Au");
  REQUIRE(plain);
  CHECK(plain->answer.material.id == "gold");
  CHECK(plain->name == "Au");
  CHECK(plain->dataset.empty());
  const auto one = find_material(library(), "Gold/johnson");
  REQUIRE(one);
  CHECK(one->answer.material.id == "gold");
  CHECK(one->name == "Gold");
  CHECK(one->dataset == "johnson");
  const auto polished = find_material(library(), "polished gold/johnson");
  REQUIRE(polished);
  CHECK(polished->answer.by == NameKind::qualified);
  CHECK(polished->answer.note == "gold; polished: a roughness, not an F0");
  CHECK(polished->dataset == "johnson");
  CHECK_FALSE(find_material(library(), "goldd"));
  CHECK_FALSE(find_material(library(), "goldd/johnson"));
}

TEST_CASE("a dataset is found by its id, by its unique beginning, and as the preferred one") {
  CHECK(find_dataset(library(), "gold", "johnson", {}).chosen().id == "johnson-1972");
  const FoundDataset preferred = find_dataset(library(), "gold", "", {});
  CHECK(preferred.dataset == preferred.material.preferred);
  CHECK(contains(error_of([] { (void)find_dataset(library(), "gold", "nobody", words_at("m.json#/a")); }),
                 "m.json#/a: gold: has no dataset nobody"));
}

TEST_CASE("an unknown name is told with its place, the nearest names and what else may stand there") {
  CHECK(contains(
      error_of([] { (void)find_dataset(library(), "glod", "", words_at("m.json#/a", "a file")); }),
      "m.json#/a: no material of the library is called glod; expected a file, or one of the nearest names: gold"));
  CHECK(error_of([] { (void)find_dataset(library(), "xyzzy", "", {}); }) ==
        "xyzzy: is no material of the library; expected a name that etak list shows");
}

TEST_CASE(
    "documents and media name materials exactly, because nothing tells there what a qualifier changes") {
  CHECK(
      contains(error_of([] { (void)find_dataset(library(), "brushed gold", "", words_at("m.json#/a")); }),
               "m.json#/a: no material of the library is called brushed gold; expected one of the nearest"));
  CHECK(contains(error_of([] { (void)medium("wet water"); }), "wet water"));
  CHECK(error_of([] { (void)find_dataset(library(), "turquoise", "", {}); }) ==
        "turquoise: no open measurement known: no open n or reflectance of the stone");
}

TEST_CASE("the outside medium is vacuum, an index above 0, a material or one of its datasets") {
  CHECK(std::get<double>(medium("").index) == 1);
  CHECK(medium("").label == "vacuum");
  CHECK(std::get<double>(medium("1.33").index) == 1.33);
  const Material water = material("water");
  CHECK(std::get<OpticalConstants>(medium("water").index) ==
        std::get<OpticalConstants>(water.preferred_dataset().optics));
  for (const Dataset& each : water.datasets) {
    const OutsideMedium found = medium("water/" + each.id);
    CHECK(found.label == "water/" + each.id);
    CHECK(std::get<OpticalConstants>(found.index) == std::get<OpticalConstants>(each.optics));
  }
  for (const char* bad : {"0", "-1.5"})
    CHECK(contains(error_of([&] { (void)medium(bad); }), "an index of refraction above 0, or a material"));
  CHECK(contains(error_of([] { (void)medium("watr/hale"); }),
                 "is called watr/hale; expected one of the nearest names: water"));
  CHECK(contains(error_of([] { (void)medium("water/nobody"); }), "place: water: has no dataset nobody"));
  CHECK(contains(error_of([] { (void)medium("spectralon"); }), "spectralon has reflectance data only"));
}
