// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "core/certainty/publications.h"
#include "core/color/srgb.h"
#include "core/image/picture.h"
#include "core/judge/engine.h"
#include "core/judge/nearest.h"
#include "core/material/quality.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/material/library_support.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr double named_codes = 3;  // the tolerance of ETK112

const F0Solver& band_solver() {
  static const F0Solver built{F0Options{}};
  return built;
}

std::array<double, 3> f0_of(const Material& material, const Dataset& dataset) {
  const LinearRgb f0 = solve(band_solver(), material, dataset).srgb_linear;
  return {f0.r, f0.g, f0.b};
}

// Codes from the nearest of these F0.
double codes_from(const std::array<double, 3>& linear, const std::vector<KnownF0>& entries) {
  double least = 255;
  for (const KnownF0& each : entries)
    least = std::min(least, code_distance(linear, each, TextureTransfer::srgb));
  return least;
}

std::vector<KnownF0> entries_of(const Material& material) {
  std::vector<KnownF0> out;
  for (const Dataset& each : material.datasets)
    if (each.doubtful.empty()) out.emplace_back().linear = f0_of(material, each);
  return out;
}

}  // namespace

TEST_CASE("a named material accepts at least 85 % of its publications that are left out") {
  const std::span<const KnownF0> others = KnownMaterials::builtin().f0();
  std::size_t all = 0, by_codes = 0, accepted = 0;
  for (std::size_t i = 0; i < library().ids().size(); ++i) {
    const Material whole = library().at(i);
    const Dataset& stated = whole.preferred_dataset();
    const MaterialBand band =
        material_band(band_solver(), whole, stated, solve(band_solver(), whole, stated));
    if (!band.band || band.band->publications < 2) continue;
    std::vector<const Dataset*> publications{&stated};
    for (const Publication& each : band.publications)
      if (each.left_out.empty()) publications.push_back(each.dataset);
    for (const Dataset* each : publications) {
      const auto rest = without_publication(whole, *each);
      if (!rest) continue;
      const std::array<double, 3> colour = f0_of(whole, *each);
      const bool near = codes_from(colour, entries_of(*rest)) <= named_codes;
      const auto named = named_band(*rest, others, colour, TextureTransfer::srgb, named_codes);
      ++all;
      by_codes += near;
      accepted += near || (named && named->holds);
    }
  }
  INFO(accepted << " of " << all << ", " << by_codes << " of them within 3 codes of another publication");
  CHECK(all >= 250);
  CHECK(100 * accepted >= 85 * all);
  CHECK(100 * by_codes < 75 * all);  // the band has work to do
}

TEST_CASE("no metal hides in the band of another under whose name it is painted") {
  const KnownMaterials& known = KnownMaterials::builtin();
  std::size_t pairs = 0;
  for (const KnownF0& named : known.f0()) {
    if (!named.conductor || !named.preferred) continue;
    const Material material = etak::test::material(named.id);
    for (const KnownF0& painted : known.f0()) {
      if (!painted.conductor || !painted.preferred || painted.id == named.id) continue;
      std::array<double, 3> colour = painted.linear;
      for (double& c : colour) c = srgb_decode(srgb_u8(c) / 255.0);
      const auto band = named_band(material, known.f0(), colour, TextureTransfer::srgb, named_codes);
      if (!band) break;
      CHECK_FALSE(band->holds);
      ++pairs;
    }
  }
  CHECK(pairs > 2000);
}

TEST_CASE("titanium as Hoffman printed it is titanium by its band, and a copper is told with gold's band") {
  TextureSet set = flat_set(96, {194, 187, 179}, {30, 30, 30});
  set.manifest.material = "titanium";
  CHECK(find(check_set(set), "ETK112") == nullptr);
  set.manifest.material = "gold";
  const CheckedFile wrong = check_set(set);
  REQUIRE(find(wrong, "ETK112") != nullptr);
  CHECK(contains(find(wrong, "ETK112")->message, "nine of ten within"));
}

TEST_CASE("a colour of the zone in the band of the named material is information that tells the band") {
  TextureSet set = flat_set(96, {182, 175, 165}, {30, 30, 30});
  REQUIRE(find(check_set(set), "ETK101") != nullptr);
  CHECK(find(check_set(set), "ETK101")->severity == Severity::error);
  set.manifest.material = "titanium";
  const CheckedFile named = check_set(set);
  REQUIRE(find(named, "ETK101") != nullptr);
  CHECK(find(named, "ETK101")->severity == Severity::info);
  CHECK(contains(find(named, "ETK101")->message, "in the band of titanium (4 publications"));
}

TEST_CASE("an unnamed grey of the zone is no error by bands where it was one by codes, of 55 four are none") {
  int accepted = 0, told = 0;
  for (int code = 124; code <= 178; ++code) {
    const Finding* zone = nullptr;
    const CheckedFile file = check_set(flat_set(64, {code, code, code}, {30, 30, 30}));
    if ((zone = find(file, "ETK101")) == nullptr) continue;
    ++told;
    accepted += zone->severity < Severity::error;
  }
  CHECK(told >= 50);
  CHECK(accepted == 4);
}

TEST_CASE(
    "a colour where half of the publications of a common material would lie is a warning that tells the band") {
  const CheckedFile near = check_set(flat_set(96, {208, 170, 108}, {30, 30, 30}));
  REQUIRE(find(near, "ETK101") != nullptr);
  INFO(find(near, "ETK101")->message);
  CHECK(find(near, "ETK101")->severity == Severity::warning);
  CHECK(contains(
      find(near, "ETK101")->message,
      "it lies where half of new publications of titanium_nitride would, which is common (4 publications"));
  const CheckedFile away = check_set(flat_set(96, {206, 171, 108}, {30, 30, 30}));
  REQUIRE(find(away, "ETK101") != nullptr);
  CHECK(find(away, "ETK101")->severity == Severity::error);
}

TEST_CASE(
    "a measured and cited dataset in the zone is information under its name, with the others of its material") {
  TextureSet set = flat_set(96, {177, 170, 162}, {30, 30, 30});  // titanium/palm-2018
  const CheckedFile unnamed = check_set(set);
  REQUIRE(find(unnamed, "ETK101") != nullptr);
  CHECK(find(unnamed, "ETK101")->severity == Severity::error);
  set.manifest.material = "titanium";
  const CheckedFile named = check_set(set);
  REQUIRE(find(named, "ETK101") != nullptr);
  CHECK(find(named, "ETK101")->severity == Severity::info);
  CHECK(contains(
      find(named, "ETK101")->message,
      "this dataset (palm-2018) lies in the zone; titanium's others at 0.59 (johnson-1974), 0.57 ("));
  CHECK(find(named, "ETK112") == nullptr);
}

TEST_CASE(
    "a colour of the zone is told which materials it could be, and half metal what it could be as a metal") {
  const CheckedFile zone = check_set(flat_set(96, {182, 175, 165}, {30, 30, 30}));
  REQUIRE(find(zone, "ETK101") != nullptr);
  CHECK(find(zone, "ETK101")->cause.starts_with("could be "));
  CHECK(contains(find(zone, "ETK101")->cause, "(p 0."));
  // Nothing is as green as this.
  const CheckedFile none = check_set(flat_set(96, {40, 170, 40}, {30, 30, 30}));
  REQUIRE(find(none, "ETK101") != nullptr);
  CHECK(find(none, "ETK101")->cause.empty());
}

TEST_CASE(
    "the flat colours of a picture are told largest first, islands of one colour and of 3 codes as one") {
  Image8 picture(64, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      // Two islands of grey that differ by two codes, a strip of black between them, and gold.
      const bool gold = y >= 48, gap = !gold && x >= 24 && x < 40;
      const std::uint8_t grey = x < 24 ? 180 : 182;
      const std::array<std::uint8_t, 3> texel = gold  ? std::array<std::uint8_t, 3>{255, 228, 156}
                                                : gap ? std::array<std::uint8_t, 3>{0, 0, 0}
                                                      : std::array<std::uint8_t, 3>{grey, grey, grey};
      std::ranges::copy(texel, picture.at(x, y).begin());
    }
  const std::vector<FlatColor> colors = flat_colors(rows_of(picture), TextureTransfer::srgb, 2);
  REQUIRE(colors.size() == 3);
  CHECK(srgb_encode(colors[0].linear[1]) * 255 == Approx(181).margin(0.1));
  CHECK(colors[0].share == Approx(2 * 22 * 46 / 4096.0).margin(0.06));
  CHECK(srgb_u8(colors[1].linear[2]) + srgb_u8(colors[2].linear[2]) == 156);
}
