// SPDX-License-Identifier: Apache-2.0
#include "core/material/catalogue.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/core/material/library_support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::vector<CatalogueEntry>& builtin_catalogue() {
  static const std::vector<CatalogueEntry> all = catalogue(library(), F0Solver(F0Options()), 2);
  return all;
}

const CatalogueEntry& entry_of(const std::string& id) {
  const auto& all = builtin_catalogue();
  return *std::find_if(all.begin(), all.end(),
                       [&](const CatalogueEntry& each) { return each.material.id == id; });
}

}  // namespace

TEST_CASE("the catalogue holds every material of the library in the order of its ids") {
  std::vector<std::string> ids;
  for (const CatalogueEntry& each : builtin_catalogue()) ids.push_back(each.material.id);
  CHECK(ids == library().ids());
}

TEST_CASE("a filter of the catalogue asks for all that it names") {
  const CatalogueEntry& gold = entry_of("gold");
  CHECK(fits(gold, {}));
  CHECK(fits(gold, {{"glass", "metal"}, "GOL", Zone::above}));
  CHECK_FALSE(fits(gold, {{"glass"}, "", {}}));
  CHECK_FALSE(fits(gold, {{}, "silver", {}}));
  CHECK_FALSE(fits(gold, {{}, "", Zone::below}));
}

TEST_CASE("the nearest material to a material's own colour is that material, at no distance") {
  const CatalogueEntry& gold = entry_of("gold");
  for (const std::variant<LinearRgb, Srgb8>& color :
       {std::variant<LinearRgb, Srgb8>(gold.result.srgb_linear), {gold.result.srgb8}}) {
    const auto found = nearest_materials(builtin_catalogue(), color, {}, 3);
    REQUIRE(found.size() == 3);
    CHECK(found[0].entry->material.id == "gold");
    CHECK(found[0].delta_e == 0);
    CHECK(found[1].delta_e <= found[2].delta_e);
  }
}

TEST_CASE("a surface's diffuse colour is offered where its class is asked for, and not else") {
  const auto is_surface = [](const NearMaterial& near) {
    return near.entry->material.material_class == "surface";
  };
  const auto all = nearest_materials(builtin_catalogue(), Srgb8{200, 180, 160}, {}, 1000);
  CHECK(std::none_of(all.begin(), all.end(), is_surface));
  const std::vector<std::string> classes{"surface"};
  const auto surfaces = nearest_materials(builtin_catalogue(), Srgb8{200, 180, 160}, classes, 1000);
  CHECK(!surfaces.empty());
  CHECK(std::all_of(surfaces.begin(), surfaces.end(), is_surface));
}

TEST_CASE("merged materials are the first with the datasets of all, each under an id of its own") {
  Material first = entry_of("gold").material, second = first;
  first.datasets.resize(1);
  second.datasets.resize(1);
  second.id = "other";
  const std::string id = first.datasets[0].id;
  const Material all = merged({first, second, second});
  CHECK(all.id == "gold");
  REQUIRE(all.datasets.size() == 3);
  CHECK(all.datasets[0].id == id);
  CHECK(all.datasets[1].id == id + "-2");
  CHECK(all.datasets[2].id == id + "-3");
}
