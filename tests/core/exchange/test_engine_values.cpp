// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/color/srgb.h"
#include "core/exchange/engine_values.h"
#include "core/fresnel/fresnel.h"
#include "core/material/library.h"
#include "tests/core/exchange/field.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ExportSurface gold_surface() {
  ExportSurface s;
  s.id = "gold";
  s.kind = SurfaceKind::metal;
  s.f0 = {1.0428, 0.7738, 0.3347};
  s.f82 = LinearRgb{0.9921, 0.8862, 0.6311};
  return s;
}

ExportSurface dielectric(double f0, LinearRgb diffuse = {}) {
  ExportSurface s;
  s.id = "clear";
  s.f0 = {f0, f0, f0};
  s.diffuse = diffuse;
  return s;
}

EngineValues fitted_values(const char* target, const ExportSurface& s, Fit fit = Fit::clamp) {
  const EngineTarget* const found = engine_target(target);
  REQUIRE(found != nullptr);
  return engine_values(*found, s, fit);
}

const Change* change(const EngineValues& v, std::string_view name) {
  for (const Change& c : v.changes)
    if (c.field == name) return &c;
  return nullptr;
}

constexpr double diamond_f0 = 0.172;  // (2.417 - 1)^2 / (2.417 + 1)^2

}  // namespace

TEST_CASE("an emission is a field of every target that has one, and a note of the others") {
  ExportSurface s = dielectric(0.04, {0.5, 0.5, 0.5});
  for (const EngineTarget& target : engine_targets()) {
    s.emission = {};
    const EngineValues dark = engine_values(target, s);
    s.emission = {4, 2, 0};
    const EngineValues lit = engine_values(target, s);
    INFO(target.id);
    CHECK(lit.fields.size() + lit.notes.size() > dark.fields.size() + dark.notes.size());
  }
  const EngineValues gltf = fitted_values("gltf", s);
  CHECK(field(gltf, "emissiveFactor").values == std::vector<double>{1, 0.5, 0});
  CHECK(field(gltf, "KHR_materials_emissive_strength.emissiveStrength").values == std::vector<double>{4});
  s.emission.g = -1;
  CHECK_THROWS_AS(fitted_values("gltf", s), Error);
}

TEST_CASE("hex, 8-bit, linear and GLSL are one value in four forms") {
  const ExportSurface s = gold_surface();
  CHECK(copy_text(fitted_values("hex", s)) == "#ffe49c");
  CHECK(copy_text(fitted_values("srgb8", s)) == "255, 228, 156");
  CHECK(copy_text(fitted_values("linear", s)) == "1.0428, 0.7738, 0.3347");
  CHECK(test::field(fitted_values("glsl", s), "f0").text == "vec3(1.0428, 0.7738, 0.3347)");
  CHECK(contains(copy_text(fitted_values("glsl", s)), "const vec3 f0 = vec3(1.0428, 0.7738, 0.3347);\n"));
  CHECK(contains(copy_text(fitted_values("glsl", s)), "const float gloss = 0.75;\n"));
  // The linear forms hold red above 1, 8 bits do not.
  CHECK(fitted_values("linear", s).changes.empty());
  CHECK(fitted_values("glsl", s).changes.empty());
  REQUIRE(change(fitted_values("hex", s), "F0"));
  CHECK(change(fitted_values("hex", s), "F0")->amount() == Approx(0.0428));
}

TEST_CASE("GLSL has no whole numbers where it wants floats") {
  ExportSurface s = dielectric(0);
  s.gloss = 1;
  for (const EngineField& f : fitted_values("glsl", s).fields) CHECK(f.text.find('.') != f.text.npos);
  CHECK(test::field(fitted_values("glsl", s), "f0").text == "vec3(0.0, 0.0, 0.0)");
}

TEST_CASE("gold's red above 1 is told by every target that ends at 1") {
  for (const auto& [target, name] : {std::pair{"unreal", "Base Color"},
                                     {"unity-metallic", "Albedo"},
                                     {"unity-specular", "Specular"},
                                     {"blender", "Base Color"},
                                     {"filament", "baseColor"},
                                     {"openpbr", "base_color"},
                                     {"gltf", "baseColorFactor"},
                                     {"gltf-specular-glossiness", "specularFactor"},
                                     {"gulbrandsen", "reflectivity"}}) {
    INFO(target);
    const EngineValues clamped = fitted_values(target, gold_surface()),
                       hue = fitted_values(target, gold_surface(), Fit::preserve_hue);
    REQUIRE(change(clamped, name));
    CHECK(change(clamped, name)->action == "clamp");
    CHECK(test::field(clamped, name).values[0] <= 1);
    CHECK(test::field(clamped, name).values[1] == Approx(0.7738));
    REQUIRE(change(hue, name));
    CHECK(change(hue, name)->action == "preserve-hue");
    const auto& kept = test::field(hue, name).values;
    CHECK(kept[1] / kept[0] == Approx(0.7738 / 1.0428).epsilon(1e-12));
  }
}

TEST_CASE("diamond is 2.15 in Unreal's Specular and 1.037 in Filament's reflectance: both clamped and told") {
  const EngineValues unreal = fitted_values("unreal", dielectric(diamond_f0));
  CHECK(test::field(unreal, "Specular").values[0] == 1);
  REQUIRE(change(unreal, "Specular"));
  CHECK(change(unreal, "Specular")->wanted[0] == Approx(2.15).margin(0.005));
  const EngineValues filament = fitted_values("filament", dielectric(diamond_f0));
  CHECK(test::field(filament, "reflectance").values[0] == 1);
  REQUIRE(change(filament, "reflectance"));
  CHECK(change(filament, "reflectance")->wanted[0] == Approx(1.037).margin(0.0005));
}

TEST_CASE("the standard dielectric has the targets' standard values") {
  const ExportSurface s = dielectric(0.04, {0.5, 0.5, 0.5});
  CHECK(test::field(fitted_values("unreal", s), "Specular").values[0] == Approx(0.5));
  CHECK(test::field(fitted_values("filament", s), "reflectance").values[0] == Approx(0.5));
  CHECK(test::field(fitted_values("blender", s), "IOR").values[0] == Approx(1.5).epsilon(1e-12));
  CHECK(test::field(fitted_values("openpbr", s), "specular_ior").values[0] == Approx(1.5).epsilon(1e-12));
  CHECK(test::field(fitted_values("gltf", s), "KHR_materials_ior.ior").values[0] ==
        Approx(1.5).epsilon(1e-12));
  for (const char* target : {"unreal", "filament", "blender", "unity-metallic", "openpbr", "gltf"})
    CHECK(fitted_values(target, s).changes.empty());
}

TEST_CASE("roughness is perceptual everywhere, smoothness and glossiness its rest") {
  const ExportSurface s = gold_surface();
  for (const auto& [target, name] : {std::pair{"unreal", "Roughness"},
                                     {"blender", "Roughness"},
                                     {"filament", "roughness"},
                                     {"openpbr", "specular_roughness"},
                                     {"gltf", "roughnessFactor"}})
    CHECK(test::field(fitted_values(target, s), name).values[0] == Approx(0.2498).margin(0.0005));
  for (const auto& [target, name] : {std::pair{"unity-metallic", "Smoothness"},
                                     {"unity-specular", "Smoothness"},
                                     {"gltf-specular-glossiness", "glossinessFactor"}})
    CHECK(test::field(fitted_values(target, s), name).values[0] == Approx(1 - 0.2498).margin(0.0005));
}

TEST_CASE("the diffuse colour is divided where the target takes the reflectance off it") {
  const ExportSurface s = dielectric(0.1, {0.5, 0.2, 0});
  // c_diff = diffuse (1 - max F0) gives Schueler's diffuse back.
  CHECK(test::field(fitted_values("gltf-specular-glossiness", s), "diffuseFactor").values[0] * (1 - 0.1) ==
        Approx(0.5));
  CHECK(test::field(fitted_values("gltf", s), "baseColorFactor").values[1] * (1 - 0.1) == Approx(0.2));
  CHECK(test::field(fitted_values("unity-specular", s), "Albedo").values[0] * (1 - 0.1) == Approx(0.5));
  CHECK(test::field(fitted_values("unity-metallic", s), "Albedo").values[0] * (1 - 0.04) == Approx(0.5));
  CHECK(test::field(fitted_values("unreal", s), "Base Color").values[0] == 0.5);
  // What then passes 1 is told.
  const EngineValues bright = fitted_values("gltf", dielectric(0.1, {0.95, 0.2, 0}));
  REQUIRE(change(bright, "baseColorFactor"));
  CHECK(change(bright, "baseColorFactor")->wanted[0] == Approx(0.95 / 0.9));
}

TEST_CASE("Unity's metallic setup has one F0 for dielectrics, and says what was wanted") {
  const EngineValues v = fitted_values("unity-metallic", dielectric(0.08));
  REQUIRE(change(v, "F0"));
  CHECK(change(v, "F0")->action == "fixed");
  CHECK(change(v, "F0")->wanted[0] == 0.08);
  CHECK(change(v, "F0")->used[0] == 0.04);
}

TEST_CASE("F82 is kept by Blender and OpenPBR and told by the targets that have no edge") {
  ExportSurface s = gold_surface();
  s.f82 = LinearRgb{0.98, 0.86, 0.62};
  for (const auto& [target, base, tint] :
       {std::tuple{"blender", "Base Color", "Specular Tint"}, {"openpbr", "base_color", "specular_color"}}) {
    const EngineValues v = fitted_values(target, s);
    CHECK(change(v, "F82") == nullptr);
    for (std::size_t c = 0; c < 3; ++c) {
      // F(1/7) of the tint model is tint times Schlick there: the F82 that was measured, whatever became of
      // F0.
      const double f0 = test::field(v, base).values[c];
      const double f82 = test::field(v, tint).values[c] * (f0 + (1 - f0) * std::pow(6.0 / 7, 5));
      CHECK(f82 == Approx(vec(*s.f82)[c]).epsilon(1e-12));
    }
  }
  for (const char* target : {"unreal", "unity-metallic", "unity-specular", "filament", "gltf"}) {
    INFO(target);
    const EngineValues v = fitted_values(target, s);
    REQUIRE(change(v, "F82"));
    CHECK(change(v, "F82")->action == "schlick");
    CHECK(change(v, "F82")->used[2] == Approx(0.3347 + (1 - 0.3347) * std::pow(6.0 / 7, 5)));
  }
}

TEST_CASE("an edge tint above 1 is told") {
  // Green of gold: 0.8862 / (0.7738 + 0.2262 (6/7)^5) = 1.0088.
  for (const auto& [target, tint] : {std::pair{"blender", "Specular Tint"}, {"openpbr", "specular_color"}}) {
    const EngineValues v = fitted_values(target, gold_surface());
    REQUIRE(change(v, tint));
    CHECK(change(v, tint)->wanted[1] == Approx(1.0088).margin(5e-5));
    CHECK(test::field(v, tint).values[1] == 1);
  }
}

TEST_CASE("Gulbrandsen's reflectivity and edge colour go back to n and k with this F0 and F82") {
  ExportSurface s = gold_surface();
  s.f0 = {0.9, 0.7, 0.4};
  s.f82 = LinearRgb{0.93, 0.8, 0.62};
  const EngineValues v = fitted_values("gulbrandsen", s);
  CHECK(change(v, "reflectivity") == nullptr);
  for (std::size_t c = 0; c < 3; ++c) {
    const double r = test::field(v, "reflectivity").values[c], g = test::field(v, "edge_color").values[c];
    const double most = (1 + std::sqrt(r)) / (1 - std::sqrt(r)), least = (1 - r) / (1 + r);
    const double n = most + g * (least - most);
    const double k = std::sqrt(std::max(0.0, (std::pow(n + 1, 2) * r - std::pow(n - 1, 2)) / (1 - r)));
    CHECK(f64::f0(n, k) == Approx(vec(s.f0)[c]).epsilon(1e-9));
    if (change(v, "F82") == nullptr)
      CHECK(f64::fresnel_exact(n, k, f82_cosine) == Approx(vec(*s.f82)[c]).margin(2e-6));
  }
  // From 1 on there is none: told, and the largest that the form takes is used.
  const EngineValues beyond = fitted_values("gulbrandsen", gold_surface());
  REQUIRE(change(beyond, "reflectivity"));
  CHECK(test::field(beyond, "reflectivity").values[0] == 0.99);
}

TEST_CASE("RGB n and k print their residual") {
  ExportSurface s = gold_surface();
  s.f0 = {0.9, 0.7, 0.4};
  s.f82 = LinearRgb{0.93, 0.8, 0.62};
  const EngineValues v = fitted_values("rgb-nk", s);
  for (std::size_t c = 0; c < 3; ++c) {
    const double n = test::field(v, "n").values[c], k = test::field(v, "k").values[c];
    const double miss = std::max(std::abs(f64::f0(n, k) - vec(s.f0)[c]),
                                 std::abs(f64::fresnel_exact(n, k, f82_cosine) - vec(*s.f82)[c]));
    CHECK(test::field(v, "residual").values[c] == Approx(miss).margin(1e-12));
  }
  CHECK(test::field(fitted_values("rgb-nk", gold_surface()), "residual").values[0] > 0.04);
  CHECK(change(fitted_values("rgb-nk", gold_surface()), "F0"));
}

TEST_CASE("glTF holds a coloured F0 by a colour over the index, and it comes out the same") {
  ExportSurface s = dielectric(0);
  s.f0 = {0.2, 0.05, 0.1};
  const EngineValues v = fitted_values("gltf", s);
  const double ior = test::field(v, "KHR_materials_ior.ior").values[0];
  const auto& color = test::field(v, "KHR_materials_specular.specularColorFactor").values;
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(std::min(std::pow((ior - 1) / (ior + 1), 2) * color[c], 1.0) ==
          Approx(vec(s.f0)[c]).epsilon(1e-12));
    CHECK(color[c] <= 1);
  }
  CHECK(v.changes.empty());
}

TEST_CASE("OpenPBR takes the luminance of a glass and tints a coloured dielectric") {
  ExportSurface glass = dielectric(0);
  glass.f0 = {0.0345, 0.0350, 0.0357};
  const EngineValues clear = fitted_values("openpbr", glass);
  CHECK(test::field(clear, "specular_color").values == std::vector<double>{1, 1, 1});
  REQUIRE(change(clear, "F0"));
  CHECK(change(clear, "F0")->action == "luminance");
  CHECK(change(clear, "F0")->amount() < 0.001);
  ExportSurface red = dielectric(0);
  red.f0 = {0.2, 0.05, 0.05};
  const EngineValues tinted = fitted_values("openpbr", red);
  CHECK(test::field(tinted, "specular_color").values[1] == Approx(0.25));
  CHECK(change(tinted, "F0") == nullptr);
  REQUIRE(change(tinted, "F90"));
  CHECK(change(tinted, "F90")->used[1] == Approx(0.25));
}

TEST_CASE("opacity has a field where it is not 1") {
  ExportSurface s = dielectric(0.04);
  for (const EngineTarget& target : engine_targets()) {
    const std::size_t opaque = engine_values(target, s).fields.size();
    ExportSurface thin = s;
    thin.opacity = 0.3;
    const std::size_t more = engine_values(target, thin).fields.size() - opaque;
    const bool color_only = target.id == "hex" || target.id == "srgb8" || target.id == "linear" ||
                            target.id == "gulbrandsen" || target.id == "rgb-nk" || target.id == "pbrt" ||
                            target.id.ends_with("_bsdf");
    CHECK(more == (color_only ? 0u : 1u));
  }
}

TEST_CASE("every material of the library goes to every target, each field in range or its change told") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const F0Options options;
  const F0Solver solver(options);
  std::size_t exported = 0;
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material material = library.at(i);
    const Dataset& dataset = material.preferred_dataset();
    const F0Result result = solver.solve(dataset.optics, dataset.flags);
    if (result.refused()) continue;
    ++exported;
    const ExportSurface s = export_surface(material, dataset, options, result, {0.4, 0.3, 0.2}, 0.6);
    for (const Fit fit : {Fit::clamp, Fit::preserve_hue})
      for (const EngineTarget& target : engine_targets()) {
        INFO(material.id << " " << target.id);
        const EngineValues v = engine_values(target, s, fit);
        CHECK(!v.fields.empty());
        CHECK(!copy_text(v).empty());
        const bool open = target.id == "linear" || target.id == "glsl" || target.id == "hlsl" ||
                          target.id == "c" || target.id == "hex" || target.id == "srgb8" ||
                          target.id == "rgb-nk" || target.id == "conductor_bsdf";
        for (const EngineField& f : v.fields)
          for (const double value : f.values) {
            CHECK(std::isfinite(value));
            CHECK(value >= (open ? -1 : 0));
            // Indices, nanometres and Abbe's number end elsewhere.
            bool share = f.name != "n" && f.name != "k";
            for (const char* const other :
                 {"ior", "thickness", "index", "eta at", "k at", "extinction", "dispersion"})
              share &= !contains(lower_case(f.name), other);
            if (!open && share) CHECK(value <= 1);
          }
        for (const Change& c : v.changes) {
          CHECK(c.wanted.size() == c.used.size());
          CHECK(c.amount() > 0);
          CHECK(!c.reason.empty());
        }
      }
  }
  CHECK(exported >= 170);
}

TEST_CASE("colours of another space are refused") {
  ExportSurface s = gold_surface();
  s.space = RgbSpace::acescg;
  CHECK(contains(error_of([&] { (void)fitted_values("unreal", s); }), "acescg"));
}

TEST_CASE("n and k give cesium's blue F82, which Gulbrandsen's form misses and tells") {
  ExportSurface cesium = gold_surface();
  cesium.f0 = {0.363857, 0.363857, 0.363857};
  cesium.f82 = LinearRgb{0.880313, 0.880313, 0.880313};
  const EngineValues index = engine_values(*engine_target("rgb-nk"), cesium);
  CHECK(f64::fresnel_exact(field(index, "n").values[2], field(index, "k").values[2], f82_cosine) ==
        Approx(0.880313).margin(1e-9));
  CHECK(index.changes.empty());
  // The least n of the form is (1 - r) / (1 + r), with the k that keeps F0.
  const EngineValues form = engine_values(*engine_target("gulbrandsen"), cesium);
  CHECK(field(form, "edge_color").values[2] == 1);
  const double n = (1 - 0.363857) / (1 + 0.363857),
               k = std::sqrt((0.363857 * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - 0.363857));
  REQUIRE(form.changes.size() == 1);
  CHECK(form.changes[0].field == "F82");
  CHECK(form.changes[0].used[2] == Approx(f64::fresnel_exact(n, k, f82_cosine)).margin(1e-9));
}
