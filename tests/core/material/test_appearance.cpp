// SPDX-License-Identifier: Apache-2.0
#include "core/material/appearance.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/material/library.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Material record_of_library(const char* id) {
  return *MaterialLibrary::builtin().find(id);
}

Clarity preferred(const char* id) {
  const Material material = record_of_library(id);
  return clarity(material, material.preferred_dataset());
}

// A liquid of n = 1.33 with one k at all wavelengths.
Material liquid(std::optional<double> k) {
  Material out;
  out.id = "mine";
  out.material_class = "liquid";
  OpticalConstants optics;
  optics.n = Spectrum{{360, 830}, {1.33, 1.33}};
  if (k) optics.k = Spectrum{{360, 830}, {*k, *k}};
  Dataset dataset;
  dataset.id = "made";
  dataset.optics = optics;
  out.datasets.push_back(dataset);
  return out;
}

}  // namespace

TEST_CASE("water, glass, diamond, ice and pmma are clear; metals, silicon, paper, soot and blood are not") {
  for (const char* id : {"water", "fused_silica", "glass_bk7", "diamond", "ice", "pmma", "sapphire", "quartz",
                         "ethanol", "polycarbonate", "halite", "air"}) {
    INFO(id << ": " << preferred(id).reason);
    CHECK(preferred(id).clear);
  }
  for (const char* id : {"gold", "silicon", "office_paper", "soot", "blood", "adipose_tissue", "liver",
                         "rhodamine", "polyimide"}) {
    INFO(id << ": " << preferred(id).reason);
    CHECK(!preferred(id).clear);
    CHECK(!preferred(id).reason.empty());
  }
}

TEST_CASE("a stone or gem that is asked for by a name of its own is not clear, though its crystal is") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  for (const char* name : {"marble", "Polished Marble", "ruby", "amethyst", "garnet", "titanium white"}) {
    const Material material = *library.find(name);
    INFO(name);
    CHECK(!clarity(material, material.preferred_dataset()).clear);
    CHECK(clarity(*library.find(material.id), material.preferred_dataset()).clear);
  }
  // Plasma lies in the same file as whole blood.
  const Material blood = *library.find("blood");
  CHECK(clarity(blood, *blood.dataset("liu-2019-plasma")).clear);
}

TEST_CASE("a body is clear where half of the light passes 1 mm") {
  // 4 pi k d / lambda = ln 2 at d = 1 mm and 555 nm: k = 3.06e-5.
  CHECK(clarity(liquid(2.8e-5), liquid(2.8e-5).datasets[0]).clear);
  CHECK(!clarity(liquid(3.4e-5), liquid(3.4e-5).datasets[0]).clear);
  CHECK(clarity(liquid(std::nullopt), liquid(std::nullopt).datasets[0]).clear);
  CHECK(clarity(liquid(std::nullopt), liquid(std::nullopt).datasets[0]).body.depth_m == 0);
}

TEST_CASE("the colour of a body is what passes the longest of four depths that lets half pass") {
  // 1e-8: exp(-4 pi 1e-8 1 m / 555 nm) = 0.797; 1e-7: 0.104 over 1 m, 0.797 over 0.1 m; and so on.
  for (const auto& [k, depth] : {std::pair{1e-8, 1.0}, {1e-7, 0.1}, {1e-6, 0.01}, {1e-5, 0.001}}) {
    const Material material = liquid(k);
    const Clarity body = clarity(material, material.datasets[0]);
    CHECK(body.body.depth_m == depth);
    // Blue is absorbed most, as the wavelength is shorter.
    CHECK(body.body.color.r > body.body.color.g);
    CHECK(body.body.color.g > body.body.color.b);
    CHECK(body.body.color.g == Approx(std::exp(-4 * 3.14159265 * 1e-8 / 548e-9)).margin(0.01));
  }
  const Material nothing = liquid(0);
  CHECK(clarity(nothing, nothing.datasets[0]).body.depth_m == 0);
  CHECK(clarity(nothing, nothing.datasets[0]).body.color == LinearRgb{1, 1, 1});
}

TEST_CASE("a dataset without k takes the colour of the least absorbing other one, but not of a film") {
  const Clarity water = preferred("water");
  CHECK(water.body.depth_m == 1);
  CHECK(contains(water.reason, "hale-1973"));
  CHECK(water.body.color.b > water.body.color.r);  // water is blue over a metre
  const Clarity zincite = preferred("zincite");
  CHECK(zincite.clear);
  CHECK(zincite.body.depth_m == 0);
}

TEST_CASE("every class has a roughness, and clear bodies are smooth") {
  const auto of = [](const char* material_class, bool clear = false) {
    Material material;
    material.material_class = material_class;
    return default_gloss(material, clear);
  };
  for (const std::string_view each : material_classes) {
    const DefaultGloss standard = of(std::string(each).c_str());
    CHECK(contains(standard.reason, std::string(each)));
    CHECK(contains(standard.reason, "a convention, no measurement"));
  }
  // Metals as they were always drawn.
  CHECK(of("metal").gloss == Gloss(0.75));
  CHECK(of("surface").gloss.roughness() == 0.9);
  CHECK(of("plastic").gloss.roughness() == 0.3);
  CHECK(of("plastic", true).gloss.roughness() == 0);
  CHECK(default_gloss_remark(of("surface")) ==
        "roughness 0.9 (gloss 0.00567): the default of class surface, a convention, no measurement");
}

TEST_CASE("everyday surfaces are as rough as their group, in the words of the convention") {
  for (const auto& [id, roughness] : {std::pair{"plastic_red", 0.3},
                                      {"painted_metal_grey", 0.35},
                                      {"skin_light", 0.45},
                                      {"leather_brown", 0.5},
                                      {"wood_oak", 0.6},
                                      {"rubber_red", 0.6},
                                      {"granite", 0.7},
                                      {"office_paper", 0.9},
                                      {"denim", 0.9},
                                      {"soil", 0.9},
                                      {"chalk", 0.9},
                                      {"brick", 0.9}}) {
    INFO(id);
    CHECK(default_gloss(record_of_library(id), false).gloss.roughness() == Approx(roughness));
  }
  CHECK(
      default_gloss_remark(default_gloss(record_of_library("plastic_red"), false)) ==
      "roughness 0.3 (gloss 0.661): the default of class surface, group plastic, a convention, no measurement");
  CHECK(default_gloss(record_of_library("brick"), false).reason ==
        "the default of class surface, a convention, no measurement");
  // A word of a group says nothing of other classes, and one that is not known says nothing at all.
  Material material;
  material.material_class = "mineral";
  material.group = "oil";
  CHECK(default_gloss(material, false).gloss.roughness() == Approx(0.3));
  material.material_class = "surface";
  material.group = "velvet";
  CHECK(default_gloss(material, false).gloss.roughness() == Approx(0.9));
}

TEST_CASE("surface and body add up to the total, and a dark total lowers F0") {
  for (const LinearRgb& total :
       {LinearRgb{0.5, 0.3, 0.1}, {0.04, 0.04, 0.04}, {0.02, 0.02, 0.02}, {1, 1, 1}, {0, 0, 0}}) {
    const TotalReflectance parts = divided(total);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(vec(parts.f0)[c] + vec(parts.diffuse)[c] == Approx(vec(total)[c]).margin(1e-15));
      CHECK(vec(parts.diffuse)[c] >= 0);
      CHECK(vec(parts.f0)[c] == Approx(std::min({0.04, total.r, total.g, total.b})).margin(1e-15));
    }
    CHECK(parts.lowered == (total.r < 0.04));
  }
  // Another surface, such as an author's: scaled as a whole, so that its colour stays.
  const TotalReflectance coloured = divided({0.04, 0.02, 0.02}, {0.08, 0.04, 0.04});
  CHECK(coloured.f0.r == Approx(0.04));
  CHECK(coloured.f0.b == Approx(0.02));
  CHECK(coloured.diffuse.b == Approx(0).margin(1e-15));
}

TEST_CASE("a saturated total keeps the assumed F0, and its dark channels have no diffuse colour") {
  // A green plastic, out of the gamut in red, and an orange.
  const TotalReflectance green = divided({-0.02, 0.347, 0.0265}), orange = divided({0.6142, 0.2309, 0.0094});
  for (const TotalReflectance& each : {green, orange}) {
    CHECK(each.f0 == LinearRgb{0.04, 0.04, 0.04});
    CHECK(!each.lowered);
    CHECK(total_reflectance_remark(each).starts_with(
        "the data are the total reflectance of a body: F0 0.04, which is assumed,"));
    CHECK(contains(total_reflectance_remark(each), "a channel that has less than F0 keeps F0"));
  }
  CHECK(green.diffuse.r == -0.02);  // as it was, for the caller to fit or keep
  CHECK(green.diffuse.g == Approx(0.307));
  CHECK(green.diffuse.b == 0);
  CHECK(orange.diffuse == LinearRgb{0.6142 - 0.04, 0.2309 - 0.04, 0});
  CHECK(!contains(total_reflectance_remark(divided({0.5, 0.3, 0.1})), "keeps F0"));
  // Black in all channels is no saturated colour, however small the differences between them are.
  const TotalReflectance black = divided({0.006, 0.007, 0.008});
  CHECK(black.lowered);
  CHECK(black.f0.r == Approx(0.007));
}

TEST_CASE(
    "n_d and Abbe's number are those of the makers' tables, and none where n does not reach the lines") {
  // Schott's data sheet of N-BK7: n_d 1.51680, V_d 64.17; Malitson 1965, table 1: fused silica 1.45846, 67.8.
  const ClearBody bk7 = preferred("glass_bk7").body, silica = preferred("fused_silica").body;
  CHECK(*bk7.n_d == Approx(1.51680).margin(1e-5));
  CHECK(*bk7.v_d == Approx(64.17).margin(0.01));
  CHECK(*silica.n_d == Approx(1.45846).margin(1e-5));
  CHECK(*silica.v_d == Approx(67.8).margin(0.05));
  // Diamond bends blue most of all gems: V_d near 55; water near 55.8.
  CHECK(*preferred("diamond").body.v_d == Approx(55).margin(1));
  Material material = liquid(0);
  CHECK(*clarity(material, material.datasets[0]).body.n_d == 1.33);
  CHECK(!clarity(material, material.datasets[0]).body.v_d);  // n that does not fall has no Abbe's number
  std::get<OpticalConstants>(material.datasets[0].optics).n = Spectrum{{500, 830}, {1.34, 1.33}};
  CHECK(clarity(material, material.datasets[0]).body.n_d);
  CHECK(!clarity(material, material.datasets[0]).body.v_d);
  std::get<OpticalConstants>(material.datasets[0].optics).n = Spectrum{{600, 830}, {1.34, 1.33}};
  CHECK(!clarity(material, material.datasets[0]).body.n_d);
}
