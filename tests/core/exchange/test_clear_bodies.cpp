// SPDX-License-Identifier: Apache-2.0
// Clear bodies, roughness and measured totals in what targets get.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/brdf/models.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/material/appearance.h"
#include "core/material/library.h"
#include "tests/core/exchange/field.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ExportSurface clear_of_library(const char* id, const LinearRgb& diffuse = {},
                               std::optional<Gloss> gloss = std::nullopt) {
  const Material material = *MaterialLibrary::builtin().find(id);
  const Dataset& dataset = material.preferred_dataset();
  const F0Options options;
  return export_surface(material, dataset, options, F0Solver(options).solve(dataset.optics), diffuse, gloss);
}

ExportSurface glass() {
  ExportSurface s;
  s.id = s.name = "glass";
  s.f0 = {0.04, 0.04, 0.04};
  s.clear = ClearBody{{0.5, 0.8, 0.25}, 0.1};
  s.gloss = Gloss::of_roughness(0);
  return s;
}

EngineValues values(const char* target, const ExportSurface& s) {
  return engine_values(*engine_target(target), s);
}

bool has_field(const EngineValues& v, std::string_view name) {
  for (const EngineField& f : v.fields)
    if (f.name == name) return true;
  return false;
}

std::string notes(const EngineValues& v) {
  std::string out;
  for (const std::string& note : v.notes) out += note + "\n";
  return out;
}

std::string all_notes(const ExportSurface& s) {
  std::string out;
  for (const std::string& note : s.notes) out += note + "\n";
  return out;
}

}  // namespace

TEST_CASE("each target that knows of transmission gets it with the index, and the others a remark") {
  const ExportSurface s = glass();
  const EngineValues gltf = values("gltf", s);
  CHECK(test::field(gltf, "KHR_materials_transmission.transmissionFactor").values == std::vector<double>{1});
  CHECK(test::field(gltf, "KHR_materials_ior.ior").values[0] == Approx(1.5).epsilon(1e-12));
  CHECK(test::field(gltf, "baseColorFactor").values == std::vector<double>{1, 1, 1});
  CHECK(test::field(gltf, "KHR_materials_volume.attenuationColor").values ==
        std::vector<double>{0.5, 0.8, 0.25});
  CHECK(test::field(gltf, "KHR_materials_volume.attenuationDistance").values == std::vector<double>{0.1});
  const EngineValues openpbr = values("openpbr", s);
  CHECK(test::field(openpbr, "transmission_weight").values == std::vector<double>{1});
  CHECK(test::field(openpbr, "transmission_color").values == std::vector<double>{0.5, 0.8, 0.25});
  CHECK(test::field(openpbr, "transmission_depth").values == std::vector<double>{0.1});
  CHECK(test::field(openpbr, "specular_ior").values[0] == Approx(1.5).epsilon(1e-12));
  const EngineValues blender = values("blender", s);
  CHECK(test::field(blender, "Transmission Weight").values == std::vector<double>{1});
  CHECK(test::field(blender, "Base Color").values == std::vector<double>{1, 1, 1});
  CHECK(test::field(blender, "IOR").values[0] == Approx(1.5).epsilon(1e-12));
  CHECK(contains(notes(blender), "0.1 m"));
  const EngineValues filament = values("filament", s);
  CHECK(test::field(filament, "transmission").values == std::vector<double>{1});
  CHECK(test::field(filament, "baseColor").values == std::vector<double>{1, 1, 1});
  CHECK(test::field(filament, "ior").values[0] == Approx(1.5).epsilon(1e-12));
  CHECK(test::field(filament, "absorption").values[0] == Approx(std::log(2) / 0.1).epsilon(1e-12));
  CHECK(test::field(filament, "absorption").values[2] == Approx(std::log(4) / 0.1).epsilon(1e-12));
  CHECK(test::field(values("unreal", s), "Refraction (Index of Refraction)").values[0] ==
        Approx(1.5).epsilon(1e-12));
  for (const char* target : {"unity-metallic", "unity-specular"})
    CHECK(test::field(values(target, s), "Alpha").values == std::vector<double>{0});
  for (const char* target :
       {"hex", "srgb8", "linear", "glsl", "unreal", "unity-metallic", "unity-specular",
        "gltf-specular-glossiness", "gulbrandsen", "rgb-nk", "conductor_bsdf", "generalized_schlick_bsdf"}) {
    INFO(target << ": " << notes(values(target, s)));
    CHECK(contains(notes(values(target, s)), "the body is clear"));
  }
}

TEST_CASE("without absorption nothing is written of it, and opaque bodies get none of this") {
  ExportSurface s = glass();
  s.clear = ClearBody{};
  CHECK(!has_field(values("gltf", s), "KHR_materials_volume.attenuationDistance"));
  CHECK(!has_field(values("filament", s), "absorption"));
  CHECK(test::field(values("openpbr", s), "transmission_depth").values == std::vector<double>{0});
  s.clear.reset();
  s.diffuse = {0.5, 0.4, 0.3};
  for (const EngineTarget& target : engine_targets()) {
    const EngineValues v = engine_values(target, s);
    for (const EngineField& f : v.fields) {
      CHECK(!contains(f.name, "ransmission"));
      CHECK(f.name != "Alpha");
    }
    CHECK(!contains(notes(v), "clear"));
  }
}

TEST_CASE("files of clear materials hold transmission, volume and index") {
  const std::vector<ExportSurface> surfaces{clear_of_library("water"), clear_of_library("diamond"),
                                            clear_of_library("gold"),
                                            clear_of_library("pmma", {0.5, 0.04, 0.03})};
  std::vector<Changes> changes;
  const std::string gltf =
      gltf_document(surfaces, GltfMaterialForm::metal_rough, GltfContainer::gltf, Fit::clamp, changes);
  CHECK(contains(
      gltf,
      "\"extensionsUsed\": [\"KHR_materials_dispersion\", \"KHR_materials_ior\", \"KHR_materials_specular\", \"KHR_materials_transmission\", \"KHR_materials_volume\"]"));
  CHECK(contains(gltf, "{\"transmissionFactor\": 1}"));
  CHECK(contains(gltf, "\"attenuationDistance\": 1}"));  // of water
  CHECK(contains(gltf, "{\"thicknessFactor\": 2}"));     // of diamond
  CHECK(contains(gltf, "the body is clear"));
  // Painted plastic and gold are not seen through: two of four transmit.
  std::size_t found = 0;
  for (std::size_t at = 0; (at = gltf.find("transmissionFactor", at)) != gltf.npos; ++at) ++found;
  CHECK(found == 2);
  const std::string mtlx = material_x(surfaces, Fit::clamp, changes);
  CHECK(contains(mtlx, "<input name=\"transmission_weight\" type=\"float\" value=\"1\" />"));
  CHECK(contains(mtlx, "<input name=\"transmission_depth\" type=\"float\" value=\"1\" />"));
  const std::string archived = gltf_document(surfaces, GltfMaterialForm::specular_glossiness,
                                             GltfContainer::gltf, Fit::clamp, changes);
  CHECK(!contains(archived, "transmission"));
}

TEST_CASE("the index of water, diamond and glass goes to the targets as that of their F0") {
  // n at 550 nm: Daimon 1.3342 (20 C), Peter 2.4237, Malitson 1.4599.
  for (const auto& [id, n] : {std::pair{"water", 1.3342}, {"diamond", 2.4237}, {"fused_silica", 1.4599}}) {
    const ExportSurface s = clear_of_library(id);
    REQUIRE(s.clear);
    CHECK(test::field(values("openpbr", s), "specular_ior").values[0] == Approx(n).margin(0.004));
    CHECK(test::field(values("unreal", s), "Refraction (Index of Refraction)").values[0] ==
          Approx(n).margin(0.004));
    CHECK(test::field(values("filament", s), "ior").values[0] == Approx(n).margin(0.004));
    // That of the largest channel, with the colour that gives F0 of all three.
    const double ior = test::field(values("gltf", s), "KHR_materials_ior.ior").values[0];
    CHECK(std::pow((ior - 1) / (ior + 1), 2) == Approx(std::max({s.f0.r, s.f0.g, s.f0.b})).epsilon(1e-12));
  }
}

TEST_CASE("a body that is not clear says why it is black") {
  CHECK(contains(all_notes(clear_of_library("soot")), "the body is taken as black"));
  CHECK(contains(all_notes(clear_of_library("blood")), "cells scatter"));
  CHECK(contains(all_notes(clear_of_library("air")), "a gas has no surface"));
  CHECK(!clear_of_library("water", {0.1, 0.1, 0.1}).clear);
  CHECK(!clear_of_library("gold").clear);
}

TEST_CASE("targets of roughness get exactly what was given, from mirror to paper") {
  ExportSurface s = glass();
  s.clear.reset();
  for (const double r : {0.0, 0.1, 0.5, 1.0}) {
    s.gloss = Gloss::of_roughness(r);
    for (const auto& [target, name] : {std::pair{"unreal", "Roughness"},
                                       {"blender", "Roughness"},
                                       {"filament", "roughness"},
                                       {"openpbr", "specular_roughness"},
                                       {"gltf", "roughnessFactor"}}) {
      CHECK(test::field(values(target, s), name).values[0] == r);
      CHECK(values(target, s).changes.empty());
    }
    for (const auto& [target, name] : {std::pair{"unity-metallic", "Smoothness"},
                                       {"unity-specular", "Smoothness"},
                                       {"gltf-specular-glossiness", "glossinessFactor"}})
      CHECK(test::field(values(target, s), name).values[0] == 1 - r);
    CHECK(test::field(values("glsl", s), "alpha").values[0] == r * r);
  }
}

TEST_CASE("where Schueler's gloss cannot hold the roughness, the change is told") {
  ExportSurface s = glass();
  for (const auto& [r, g, nearest] :
       {std::tuple{0.0, 1.0, roughness_of_gloss(1)}, {1.0, 0.0, roughness_of_gloss(0)}}) {
    s.gloss = Gloss::of_roughness(r);
    const EngineValues v = values("glsl", s);
    CHECK(test::field(v, "gloss").values[0] == g);
    REQUIRE(v.changes.size() == 1);
    CHECK(v.changes[0].field == "roughness");
    CHECK(v.changes[0].wanted[0] == r);
    CHECK(v.changes[0].used[0] == Approx(nearest).epsilon(1e-12));
    CHECK(v.changes[0].action == "clamp");
  }
  s.gloss = Gloss::of_roughness(0.5);
  CHECK(values("glsl", s).changes.empty());
  s.gloss = Gloss::of_roughness(1.5);
  CHECK(contains(error_of([&] { validate(s); }), "roughness 1.5"));
}

TEST_CASE("without a word the class decides, and says that it is a convention") {
  CHECK(clear_of_library("gold").gloss == Gloss(0.75));
  CHECK(clear_of_library("cardboard").gloss.roughness() == 0.9);
  CHECK(clear_of_library("water").gloss.roughness() == 0);
  CHECK(clear_of_library("pmma", {0.5, 0.04, 0.03}).gloss.roughness() == 0.3);
  CHECK(contains(all_notes(clear_of_library("cardboard")),
                 "the default of class surface, a convention, no measurement"));
  const ExportSurface given = clear_of_library("cardboard", {}, Gloss(0.5));
  CHECK(given.gloss == 0.5);
  CHECK(!contains(all_notes(given), "convention"));
}

// What a target sends back of white light at normal incidence, by the formulas of its own shader.
namespace {

LinearRgb color(const EngineValues& v, std::string_view name) {
  const std::vector<double>& c = test::field(v, name).values;
  return {c[0], c[1], c[2]};
}

double f0_of_ior(double ior) {
  return std::pow((ior - 1) / (ior + 1), 2);
}

// Per channel.
Vec3 total_of(const std::string& target, const EngineValues& v) {
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto layered = [&](double base, double f0) { return f0 + (1 - f0) * base; };
    if (target == "glsl")
      out[c] = vec(color(v, "f0"))[c] + (has_field(v, "diffuse") ? vec(color(v, "diffuse"))[c] : 0);
    else if (target == "unreal")
      out[c] = vec(color(v, "Base Color"))[c] + 0.08 * test::field(v, "Specular").values[0];
    else if (target == "filament")
      out[c] = vec(color(v, "baseColor"))[c] + 0.16 * std::pow(test::field(v, "reflectance").values[0], 2);
    else if (target == "blender")
      out[c] = layered(vec(color(v, "Base Color"))[c], f0_of_ior(test::field(v, "IOR").values[0]));
    else if (target == "openpbr")
      out[c] = layered(vec(color(v, "base_color"))[c], f0_of_ior(test::field(v, "specular_ior").values[0]));
    else if (target == "gltf")
      out[c] = layered(vec(color(v, "baseColorFactor"))[c],
                       f0_of_ior(test::field(v, "KHR_materials_ior.ior").values[0]));
    else
      out[c] = layered(vec(color(v, "diffuseFactor"))[c], vec(color(v, "specularFactor"))[c]);
  }
  return out;
}

}  // namespace

TEST_CASE(
    "every measured total comes out of every target again at normal incidence, and where a channel has less than the assumed F0 that") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  std::size_t surfaces = 0, saturated = 0;
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material material = library.at(i);
    if (material.material_class != "surface") continue;
    const F0Options options;
    const Dataset& dataset = material.preferred_dataset();
    const F0Result result = F0Solver(options).solve(dataset.optics, dataset.flags);
    if (result.refused()) continue;
    ++surfaces;
    const ExportSurface s = export_surface(material, dataset, options, result, {}, std::nullopt);
    REQUIRE(s.total);
    validate(s);
    CHECK(contains(all_notes(s), "total reflectance"));
    const bool less = std::min({s.total->r, s.total->g, s.total->b}) < s.f0.g - 1e-12;
    CHECK(contains(all_notes(s), "keeps F0") == less);
    CHECK(contains(all_notes(s), "F0 0.04, which is assumed") == (s.f0.g == 0.04));
    saturated += less && s.f0.g == 0.04 ? 1 : 0;
    for (const char* target :
         {"glsl", "unreal", "filament", "blender", "openpbr", "gltf", "gltf-specular-glossiness"}) {
      INFO(material.id << " " << target);
      const Vec3 out = total_of(target, values(target, s));
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(out[c] == Approx(std::clamp(vec(result.linear)[c], vec(s.f0)[c], 1.0)).margin(1e-9));
    }
    // Unity's metallic setup has an F0 of its own: what is darker than that is told.
    const EngineValues unity = values("unity-metallic", s);
    const bool dark = std::min({s.total->r, s.total->g, s.total->b}) < 0.04;
    CHECK(unity.changes.empty() == !dark);
  }
  CHECK(surfaces >= 18);
  CHECK(saturated >= 18);
}

TEST_CASE("the lobe and Lambert's body reflect the measured total, as integrated over the hemisphere") {
  const ExportSurface s = clear_of_library("brick", {}, Gloss(0.75));
  const Model& lobe = *find_model("ggx-schlick");
  for (std::size_t c = 0; c < 3; ++c) {
    const double f0 = vec(s.f0)[c], alpha = s.gloss.alpha();
    // At normal incidence an isotropic lobe depends on the angle of the light alone: 2 pi f cos sin over it.
    constexpr int steps = 20000;
    double specular = 0;
    for (int i = 0; i < steps; ++i) {
      const double theta = (i + 0.5) / steps * std::numbers::pi / 2;
      const double numbers[] = {f0, f0, f0, alpha};
      double rgb[3] = {0, 0, 0};
      lobe.f64({std::sin(theta), 0, std::cos(theta), 0, 0, 1}, numbers, rgb);
      specular +=
          2 * std::numbers::pi * rgb[c] * std::cos(theta) * std::sin(theta) * std::numbers::pi / 2 / steps;
    }
    CHECK(specular + vec(s.diffuse)[c] == Approx(vec(*s.total)[c]).margin(0.001));
  }
}
