// SPDX-License-Identifier: Apache-2.0
#include "core/material/material.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("every flag has a name of its own that reads back, in kebab case, and a meaning") {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < flag_count; ++i) {
    const auto flag = static_cast<Flag>(i);
    CHECK(flag_named(name(flag)) == flag);
    CHECK(!meaning(flag).empty());
    CHECK(name(flag).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos);
    names.insert(name(flag));
  }
  CHECK(names.size() == flag_count);
  CHECK(name(Flag::extrapolated) == "extrapolated");
  CHECK(name(Flag::out_of_gamut) == "out-of-gamut");
  CHECK(name(Flag::duplicate_wavelength) == "duplicate-wavelength");
  CHECK(name(Flag::k_assumed_0) == "k-assumed-0");
  CHECK(name(Flag::unpaired_coefficient) == "unpaired-coefficient");
  CHECK(!flag_named("Extrapolated"));
  CHECK(!flag_named(""));
}

TEST_CASE("a set of flags holds what was put in and visits it in order") {
  Flags flags;
  CHECK(flags.none());
  flags.set(Flag::reflectance_clamped);
  flags.set(Flag::gap);
  flags.set(Flag::gap);
  CHECK(flags.has(Flag::gap));
  CHECK(!flags.has(Flag::unsorted));
  std::vector<Flag> visited;
  flags.for_each([&](Flag flag) { visited.push_back(flag); });
  CHECK(visited == std::vector<Flag>{Flag::gap, Flag::reflectance_clamped});
  CHECK(Flags::from_bits(flags.bits()) == flags);
  Flags more;
  more.set(Flag::unsorted);
  more |= flags;
  CHECK(more.has(Flag::unsorted));
  CHECK(more.has(Flag::gap));
  CHECK(more != flags);
}

TEST_CASE("origins read back") {
  for (const auto origin : {Origin::measured, Origin::fit, Origin::computed, Origin::unknown})
    CHECK(origin_named(name(origin)) == origin);
  CHECK(!origin_named("guessed"));
}

TEST_CASE("every class has one of four optical kinds") {
  const std::set<std::string_view> kinds{"conductor", "semiconductor", "surface", "dielectric"};
  for (const auto material_class : material_classes) CHECK(kinds.count(optical_kind(material_class)) == 1);
  CHECK(optical_kind("metal") == "conductor");
  CHECK(optical_kind("alloy") == "conductor");
  CHECK(optical_kind("semiconductor") == "semiconductor");
  CHECK(optical_kind("surface") == "surface");
  CHECK(optical_kind("gem") == "dielectric");
  CHECK(optical_kind("liquid") == "dielectric");
}

TEST_CASE("a dataset is found by its id") {
  Material material;
  material.datasets.resize(2);
  material.datasets[0].id = "a";
  material.datasets[1].id = "b";
  material.preferred = 1;
  CHECK(material.dataset("b") == &material.datasets[1]);
  CHECK(material.dataset("c") == nullptr);
  CHECK(material.preferred_dataset().id == "b");
}

TEST_CASE("a citation is one line with authors, title, place, year and doi, and no empty parts") {
  const Citation full{{"P. B. Johnson", "R. W. Christy"},
                      "Optical constants of the noble metals",
                      "Phys. Rev. B 6, 4370",
                      1972,
                      "10.1103/PhysRevB.6.4370",
                      "https://example.org",
                      "CC0-1.0",
                      "collection"};
  const std::string line = one_line(full);
  for (const auto* part : {"P. B. Johnson", "R. W. Christy", "Optical constants", "Phys. Rev. B 6, 4370",
                           "1972", "10.1103/PhysRevB.6.4370"})
    CHECK(contains(line, part));
  CHECK(!contains(line, "\n"));
  CHECK(!contains(one_line(Citation{{}, "Title", "", 0, "", "", "CC0-1.0", ""}), "0"));
  CHECK(one_line(Citation{}).empty());
  CHECK(!contains(one_line(Citation{{"A"}, "", "J. 1", 2000, "", "", "", ""}), ", ,"));
}
