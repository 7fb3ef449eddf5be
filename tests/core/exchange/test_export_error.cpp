// SPDX-License-Identifier: Apache-2.0
// Errors that exports tell, computed again, and targets whose text is a document.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/base/text/ascii.h"
#include "core/exchange/export_input.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/fresnel/fresnel.h"
#include "core/material/find.h"
#include "tests/core/exchange/field.h"
#include "tests/core/material/library_support.h"
#include "tests/gltf_judge.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const LibraryWhenAsked library_for_errors = []() -> const MaterialLibrary& { return library(); };

ExportSurface exported_surface(const std::string& name, const F0Options& options = {}) {
  InputNames names;
  names.names = {name};
  ExportAnswer answer =
      export_answer(find_inputs(names, library_for_errors, 1).at(0), {}, F0Solver(options), {});
  REQUIRE(answer.refusal == "");
  return *answer.surface;
}

EngineValues values_in(const char* target, const ExportSurface& surface) {
  return engine_values(*engine_target(target), surface);
}

// A dielectric of one index at all wavelengths.
ExportSurface glass_without_dispersion(double n) {
  Material material;
  material.id = material.name = "flat";
  material.material_class = "glass";
  Dataset dataset;
  dataset.id = "flat";
  OpticalConstants optics;
  optics.n = Spectrum{{360, 830}, {n, n}};
  optics.k = Spectrum{{360, 830}, {0, 0}};
  dataset.optics = optics;
  material.datasets = {dataset};
  const F0Result result = F0Solver({}).solve(dataset.optics);
  return export_surface(material, dataset, {}, result, {}, Gloss(0.75));
}

Lab lab_of_grey(double f) {
  const double cut = std::clamp(f, 0.0, 1.0);
  return to_lab(LinearRgb{cut, cut, cut});
}

// Unpolarised reflectance of a real index by Fresnel's sines and tangents.
double by_sines(double n, double degrees) {
  if (degrees == 0) return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
  const double in = degrees * std::numbers::pi / 180, out = std::asin(std::sin(in) / n);
  const double s = std::sin(in - out) / std::sin(in + out), p = std::tan(in - out) / std::tan(in + out);
  return (s * s + p * p) / 2;
}

}  // namespace

TEST_CASE("the error of Schlick's curve for a glass is that of Fresnel's sines and tangents") {
  const double n = 1.5;
  double mean = 0, weights = 0, largest = 0;
  for (int degrees = 0; degrees <= 84; degrees += 6) {
    const double angle = degrees * std::numbers::pi / 180;
    const double schlick = 0.04 + 0.96 * std::pow(1 - std::cos(angle), 5);
    const double off = delta_e2000(lab_of_grey(schlick), lab_of_grey(by_sines(n, degrees)));
    mean += off * std::sin(angle) * std::cos(angle);
    weights += std::sin(angle) * std::cos(angle);
    largest = std::max(largest, off);
  }
  const ExportSurface glass = glass_without_dispersion(n);
  for (const char* const target :
       {"unreal", "unity-metallic", "unity-hdrp", "filament", "godot", "gltf", "usd"}) {
    INFO(target);
    const EngineValues values = values_in(target, glass);
    REQUIRE(values.error);
    CHECK(values.error->mean == Approx(mean / weights).margin(2e-4));
    CHECK(values.error->largest == Approx(largest).margin(2e-4));
    CHECK(values.error->normal == Approx(0).margin(2e-4));
  }
  // Fresnel's own equations have no error, and three.js' exponential is no more than 1 dE from the power.
  for (const char* const target : {"openpbr", "blender", "standard-surface", "rgb-nk"})
    CHECK(values_in(target, glass).error->largest < 2e-4);
  CHECK(std::abs(values_in("threejs", glass).error->mean - mean / weights) < 1);
}

TEST_CASE("every target states its version, and its error or why it has none") {
  for (const EngineTarget& target : engine_targets()) {
    INFO(target.id);
    CHECK_FALSE(target.version.empty());
    CHECK((!target.formula.empty() || !target.unstated.empty()));
  }
  for (const std::string& id : library().ids()) {
    const Material material = *library().find(id);
    if (std::holds_alternative<Stack>(material.preferred_dataset().optics)) continue;
    const F0Result result = F0Solver({}).solve(material.preferred_dataset().optics);
    if (result.refused()) continue;
    const ExportSurface surface =
        export_surface(material, material.preferred_dataset(), {}, result, {}, Gloss(0.75));
    for (const EngineTarget& target : engine_targets()) {
      const EngineValues values = engine_values(target, surface);
      INFO(material.id << " " << target.id);
      CHECK(values.error.has_value() == values.error_reason.empty());
      // Renderers of spectra are given the numbers themselves, but for dielectrics of Mitsuba, which have one index.
      const bool stated =
          target.unstated.empty() || (target.id == "mitsuba" && surface.kind == SurfaceKind::dielectric);
      CHECK(values.error.has_value() == (surface.seen.has_value() && stated));
      if (values.error)
        CHECK((std::isfinite(values.error->mean) && values.error->mean <= values.error->largest));
    }
  }
}

TEST_CASE("the F90 of Substrate gives the edge of a metal, and no metal of the library is worse by it") {
  std::size_t metals = 0, nearer = 0;
  for (const std::string& id : library().ids()) {
    const Material material = *library().find(id);
    if (optical_kind(material.material_class) != "conductor") continue;
    if (!std::holds_alternative<OpticalConstants>(material.preferred_dataset().optics)) continue;
    const F0Result result = F0Solver({}).solve(material.preferred_dataset().optics);
    if (result.refused() || !result.f82) continue;
    const ExportSurface surface =
        export_surface(material, material.preferred_dataset(), {}, result, {}, Gloss(0.75));
    const EngineValues slab = values_in("unreal-substrate", surface), plain = values_in("unreal", surface);
    const std::vector<double> f0 = field(slab, "F0").values, f90 = field(slab, "F90").values;
    INFO(material.id);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK((f90[c] >= 0 && f90[c] <= 1));
      if (f90[c] > 0 && f90[c] < 1 && f0[c] < 1)
        CHECK(f0[c] + (f90[c] - f0[c]) * std::pow(6.0 / 7, 5) == Approx(vec(*surface.f82)[c]).margin(1e-9));
    }
    ++metals;
    nearer += slab.error->mean <= plain.error->mean + 1e-9 ? 1 : 0;
  }
  CHECK(metals > 40);
  CHECK(nearer * 10 >= metals * 9);
}

TEST_CASE(
    "dispersion is 20 over Abbe's number in glTF, three.js and gltf_pbr, the number itself in Standard Surface") {
  const ExportSurface glass = exported_surface("glass_bk7");
  REQUIRE(glass.clear);
  const double v_d = glass.clear->v_d.value();
  CHECK(v_d == Approx(64.17).margin(0.05));  // Schott's catalogue
  CHECK(field(values_in("gltf", glass), "KHR_materials_dispersion.dispersion").values[0] == Approx(20 / v_d));
  CHECK(field(values_in("threejs", glass), "dispersion").values[0] == Approx(20 / v_d));
  CHECK(field(values_in("gltf-pbr", glass), "dispersion").values[0] == Approx(20 / v_d));
  CHECK(field(values_in("standard-surface", glass), "transmission_dispersion").values[0] == Approx(v_d));
  std::vector<Changes> changes;
  const std::string text = gltf_document(std::vector{glass}, GltfMaterialForm::metal_rough,
                                         GltfContainer::gltf, Fit::clamp, changes);
  CHECK(contains(text, "\"KHR_materials_dispersion\": {\"dispersion\": "));
  const TempFolder folder;
  const std::string file = folder.file("glass.gltf");
  spit(file, text);
  if (const auto messages = gltf_messages(folder.path(), {file})) CHECK(*messages == "");
}

TEST_CASE("inputs of MaterialX nodes are those of the published definitions") {
  // Names and types of MaterialX 1.39, libraries/bxdf/standard_surface.mtlx and gltf_pbr.mtlx.
  const std::map<std::string, std::set<std::string>> floats{
      {"standard-surface",
       {"base", "metalness", "specular", "specular_roughness", "specular_IOR", "transmission",
        "transmission_depth", "transmission_dispersion", "coat", "emission"}},
      {"gltf-pbr",
       {"metallic", "roughness", "ior", "specular", "transmission", "attenuation_distance", "thickness",
        "dispersion", "clearcoat", "clearcoat_roughness", "iridescence", "iridescence_ior",
        "iridescence_thickness", "emissive_strength", "alpha"}}};
  const std::map<std::string, std::set<std::string>> colors{
      {"standard-surface",
       {"base_color", "specular_color", "transmission_color", "coat_color", "emission_color", "opacity"}},
      {"gltf-pbr", {"base_color", "specular_color", "attenuation_color", "emissive"}}};
  for (const char* const name : {"gold", "glass_bk7", "chalk", "water", "silicon"}) {
    ExportSurface surface = exported_surface(name);
    surface.opacity = 0.5;
    surface.emission = {4, 2, 0};
    for (const auto& [target, known] : floats) {
      const EngineValues values = engine_values(*engine_target(target), surface);
      for (const EngineField& each : values.fields) {
        INFO(target << " " << name << " " << each.name);
        CHECK((each.values.size() == 1 ? known : colors.at(target)).contains(each.name));
      }
    }
  }
}

TEST_CASE("documents hold every material once, under names of their own") {
  std::vector<ExportSurface> surfaces{exported_surface("gold"), exported_surface("gold"),
                                      exported_surface("glass_bk7"), exported_surface("chalk")};
  for (const char* const id :
       {"standard-surface", "gltf-pbr", "usd", "pbrt", "mitsuba", "luxcore", "blender-metallic"}) {
    const EngineTarget* const target = engine_target(id);
    const std::string text =
        export_text(exported_values(surfaces, {"a", "b", "c", "d"}, {target}, Fit::clamp, 1));
    INFO(text);
    CHECK(text.starts_with(target->opens));
    CHECK(text.find(target->opens, 1) == text.npos);
    CHECK(text.ends_with(target->closes));
    if (std::string_view(id) != "blender-metallic") CHECK(contains(text, "\"gold_2"));
    CHECK(std::ranges::count(text, '{') == std::ranges::count(text, '}'));
  }
  // Values of several materials are told apart by headings in the language's own comments.
  const std::string hlsl =
      export_text(exported_values(surfaces, {"a", "b", "c", "d"}, {engine_target("hlsl")}, Fit::clamp, 1));
  CHECK(hlsl.starts_with("// Gold, HLSL\nstatic const float3 f0 = float3("));
}

TEST_CASE("every text says which medium F0 is against, where that is not vacuum") {
  F0Options wet;
  wet.outside = outside_medium(library(), "water", "place", {});
  const ExportSurface gold = exported_surface("gold", wet), dry = exported_surface("gold");
  for (const EngineTarget& target : engine_targets()) {
    const auto text = [&](const ExportSurface& s) {
      return export_text(exported_values({s}, {"a"}, {&target}, Fit::clamp, 1));
    };
    INFO(target.id << "\n" << text(gold));
    CHECK(contains(text(gold), "F0 against water"));
    CHECK(!contains(text(dry), "against"));
  }
}

TEST_CASE("renderers of spectra get n and k at every 5 nm as the data have them") {
  const ExportSurface gold = exported_surface("gold/johnson-1972");
  REQUIRE(gold.spectrum.size() == 95);
  CHECK(gold.spectrum.front().nm == 360);
  CHECK(gold.spectrum.back().nm == 830);
  const std::string text = copy_text(values_in("pbrt", gold));
  CHECK(contains(text, "\"string type\" \"conductor\""));
  CHECK(contains(text, "\"bool remaproughness\" false"));
  const std::string scene = copy_text(values_in("mitsuba", gold));
  CHECK(contains(scene, "<bsdf type=\"roughconductor\" id=\"gold\">"));
  CHECK(contains(scene, "<spectrum name=\"eta\" value=\"360:"));
  // Data of reflectance alone have no n and k.
  CHECK(exported_surface("chalk").spectrum.empty());
}
