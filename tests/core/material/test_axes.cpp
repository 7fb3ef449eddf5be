// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/axes.h"

#include <catch2/catch.hpp>

using namespace etak;

namespace {

Dataset dataset(const std::string& id, const std::string& axis, int year, double kelvin) {
  Dataset out;
  out.id = id;
  out.axis = axis;
  out.temperature_kelvin = kelvin;
  out.citation.authors = {"A. Author"};
  out.citation.year = year;
  return out;
}

}  // namespace

TEST_CASE("the weights of a crystal system's axes add up to 1") {
  for (const char* name : {"ordinary", "beta"}) {
    double sum = 0;
    for (const CrystalAxis& axis : axes_of_system(name, &CrystalAxis::name)) sum += axis.weight;
    CHECK(sum == Approx(1).margin(1e-15));
  }
  CHECK(axes_of_system("isotropic", &CrystalAxis::name).empty());
  CHECK(axis_named("γ") == axis_named("gamma"));
  CHECK(axis_named("O") == nullptr);
}

TEST_CASE("the other axes are of the same source, at the same temperature where there is a choice") {
  Material crystal;
  crystal.datasets = {dataset("o", "ordinary", 2000, 300), dataset("e-hot", "extraordinary", 2000, 600),
                      dataset("e", "extraordinary", 2000, 300), dataset("late", "extraordinary", 2010, 300)};
  const auto axes = axis_datasets(crystal, crystal.datasets[0]);
  REQUIRE(axes.size() == 2);
  CHECK(axes[0].dataset == &crystal.datasets[0]);
  CHECK(axes[1].dataset == &crystal.datasets[2]);
  const auto alone = axis_datasets(crystal, crystal.datasets[3]);
  REQUIRE(alone.size() == 2);
  CHECK(alone[0].dataset == nullptr);
}
