// SPDX-License-Identifier: Apache-2.0
// Exports with a clear coat: what each target draws of the values that it is given, by arithmetic written out from the
// target's own definition, beside the exact reflectance of base and coat.
#include "core/exchange/export_coat.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/color/colorspace.h"
#include "core/color/delta_e.h"
#include "core/exchange/export_input.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/material/f0/f0_settings.h"
#include "core/material/find.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/interpolate.h"
#include "tests/core/exchange/field.h"
#include "tests/core/material/library_support.h"
#include "tests/gltf_judge.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const LibraryWhenAsked known = []() -> const MaterialLibrary& { return library(); };

ExportAnswer coated_answer(const std::string& name, const std::string& coat, ExportWishes wishes = {}) {
  InputNames names;
  names.names = {name};
  wishes.coat = coat_setting(coat, known);
  return export_answer(find_inputs(names, known, 1).at(0), {}, F0Solver({}), wishes);
}

ExportSurface coated_surface(const std::string& name, const std::string& coat) {
  ExportAnswer answer = coated_answer(name, coat);
  REQUIRE(answer.refusal == "");
  return *answer.surface;
}

EngineValues values_for(const char* target, const ExportSurface& surface) {
  return engine_values(*engine_target(target), surface, Fit::clamp);
}

double number_of(const EngineValues& values, const char* name) {
  return field(values, name).values.at(0);
}

// Channels whose values the target could hold: gold's red is above 1.
constexpr std::array<std::size_t, 2> held{1, 2};

double schlick(double f0, double c) {
  return f0 + (1 - f0) * std::pow(1 - c, 5);
}

// Fresnel's equations for a clear medium of index n in air.
double clear_fresnel(double n, double c) {
  const double t = std::sqrt(1 - (1 - c * c) / (n * n));
  const double s = (c - n * t) / (c + n * t), p = (n * c - t) / (n * c + t);
  return (s * s + p * p) / 2;
}

// What is reflected of light in air by a clear coat of index n that is thicker than light stays in step, on a conductor:
// the sum of all that goes up and down in it, for s and p by themselves.
double coated_reflectance(double n, std::complex<double> base, double c) {
  const std::complex<double> ratio = base / n;
  const double inside = std::sqrt(1 - (1 - c * c) / (n * n));
  const std::complex<double> below = std::sqrt(1.0 - (1 - inside * inside) / (ratio * ratio));
  const std::array<double, 2> top{(c - n * inside) / (c + n * inside), (n * c - inside) / (n * c + inside)};
  const std::array<std::complex<double>, 2> bottom{(inside - ratio * below) / (inside + ratio * below),
                                                   (ratio * inside - below) / (ratio * inside + below)};
  double sum = 0;
  for (std::size_t way = 0; way < 2; ++way) {
    const double r = top[way] * top[way], b = std::norm(bottom[way]);
    sum += (r + (1 - r) * (1 - r) * b / (1 - r * b)) / 2;
  }
  return sum;
}

Lab cut_lab(const Vec3& c) {
  return to_lab(
      LinearRgb{std::clamp(c[0], 0.0, 1.0), std::clamp(c[1], 0.0, 1.0), std::clamp(c[2], 0.0, 1.0)});
}

double tint_at(double f0, double tint) {
  return tint * schlick(f0, 1.0 / 7);
}

const std::vector<std::pair<std::string, std::string>> metals{
    {"gold", "1.5"}, {"copper", "1.33"}, {"titanium", "1.7"}, {"gold", "pmma"}, {"silver", "water:3000mm"}};

}  // namespace

TEST_CASE("what glTF draws of a metal and its coat of 1.5 adds up to the whole") {
  for (const auto& [metal, coat] : metals) {
    INFO(metal << " " << coat);
    const ExportSurface s = coated_surface(metal, coat);
    const EngineValues v = values_for("gltf", s);
    CHECK(number_of(v, "KHR_materials_clearcoat.clearcoatFactor") == 1);
    CHECK(number_of(v, "KHR_materials_clearcoat.clearcoatRoughnessFactor") == 0);
    const auto& base = field(v, "baseColorFactor").values;
    // mix(base, coat, 0.04) at normal incidence. Where the coat has another index its own part is off, and told.
    for (const std::size_t c : held)
      CHECK(0.04 + 0.96 * base[c] == Approx(vec(s.coat->whole.linear)[c]).epsilon(1e-9));
    bool told = false;
    for (const Change& change : v.changes) told = told || change.field == "F0 of the coat";
    CHECK(told == (coat != "1.5"));
  }
  const ExportSurface gold = coated_surface("gold", "1.5");
  const auto base = field(values_for("gltf", gold), "baseColorFactor").values;
  CHECK(0.04 + 0.96 * base[1] == Approx(gold.coat->whole.linear.g).epsilon(1e-9));
  CHECK(gold.coat->whole.linear.g == Approx(0.7319).margin(5e-5));
  // Counted twice, F0 of air would be given.
  CHECK(base[1] < gold.f0.g - 0.04);
}

TEST_CASE("what MaterialX draws of OpenPBR's metal and coat is the whole, head on and at cosine 1/7") {
  for (const auto& [metal, coat] : metals) {
    INFO(metal << " " << coat);
    const ExportSurface s = coated_surface(metal, coat);
    const EngineValues v = values_for("openpbr", s);
    CHECK(number_of(v, "coat_weight") == 1);
    CHECK(number_of(v, "coat_roughness") == 0);
    CHECK(number_of(v, "coat_darkening") == 0);
    const double n = number_of(v, "coat_ior");
    const double own = (n - 1) * (n - 1) / ((n + 1) * (n + 1)), own82 = clear_fresnel(n, 1.0 / 7);
    for (const std::size_t c : held) {
      const double base = field(v, "base_color").values[c], color = field(v, "coat_color").values[c];
      CHECK(own + (1 - own) * color * base == Approx(vec(s.coat->whole.linear)[c]).epsilon(1e-9));
      const double tint = field(v, "specular_color").values[c];
      if (tint == 1) continue;  // clamped, and told
      CHECK(own82 + (1 - own82) * color * tint_at(base, tint) ==
            Approx(vec(*s.coat->whole.f82)[c]).epsilon(1e-9));
    }
  }
}

TEST_CASE("what Blender draws of a metal and its coat is the whole, its tint to the power of the path") {
  for (const auto& [metal, coat] : metals) {
    INFO(metal << " " << coat);
    const ExportSurface s = coated_surface(metal, coat);
    const EngineValues v = values_for("blender", s);
    const double n = number_of(v, "Coat IOR");
    const double own = (n - 1) * (n - 1) / ((n + 1) * (n + 1)), own82 = clear_fresnel(n, 1.0 / 7);
    const double path = 1 / std::sqrt(1 - (1 - 1.0 / 49) / (n * n));
    for (const std::size_t c : held) {
      const double base = field(v, "Base Color").values[c], color = field(v, "Coat Tint").values[c];
      CHECK(own + (1 - own) * color * base == Approx(vec(s.coat->whole.linear)[c]).epsilon(1e-9));
      const double tint = field(v, "Specular Tint").values[c];
      if (tint == 1) continue;
      CHECK(own82 + (1 - own82) * std::pow(color, path) * tint_at(base, tint) ==
            Approx(vec(*s.coat->whole.f82)[c]).epsilon(1e-9));
    }
  }
}

TEST_CASE("Filament's own change of F0 under its coat is undone in the values that it is given") {
  for (const auto& [metal, coat] : metals) {
    INFO(metal << " " << coat);
    const ExportSurface s = coated_surface(metal, coat);
    const EngineValues v = values_for("filament", s);
    CHECK(number_of(v, "clearCoat") == 1);
    for (const std::size_t c : held) {
      const double f = field(v, "baseColor").values[c];
      const double under = -0.263008 * f * f * f + 0.941892 * f * f + 0.346479 * f - 0.0285998;
      if (f == 1) continue;  // its polynomial ends at 0.9968: clamped, and told
      CHECK(0.04 + 0.96 * under == Approx(vec(s.coat->whole.linear)[c]).epsilon(1e-6));
    }
  }
}

TEST_CASE("the error under a coat is that of the target's own sum of coat and base against the exact whole") {
  // Silver lies within [0, 1], so that nothing is cut. The exact whole by intensities: what goes up and down below a coat
  // of a constant index is a series, summed here for s and p by themselves at every wavelength.
  const ExportSurface s = coated_surface("silver", "1.5");
  REQUIRE(s.seen);
  const double n = 1.5;
  const Material silver = *library().find("silver");
  const auto& optics = std::get<OpticalConstants>(silver.preferred_dataset().optics);
  const Quadrature q = make_quadrature(Method::nm1, {Observer::cie1931_2deg, Illuminant::d65});
  std::vector<double> base_n(q.wavelength_nm.size()), base_k = base_n;
  resample(std::get<Spectrum>(optics.n), Interpolation::linear, q.wavelength_nm, base_n);
  resample(optics.k.value(), Interpolation::linear, q.wavelength_nm, base_k);
  const Xyz white = to_xyz(q.white());
  const Mat3 to_srgb = xyz_to_rgb(RgbSpace::srgb, white, white);
  const EngineValues gltf = values_for("gltf", s), blender = values_for("blender", s);
  double mean_gltf = 0, mean_blender = 0, weights = 0, worst = 0;
  for (int degrees = 0; degrees <= 84; degrees += 6) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle);
    std::vector<double> whole(q.wavelength_nm.size());
    for (std::size_t i = 0; i < whole.size(); ++i)
      whole[i] = coated_reflectance(n, {base_n[i], base_k[i]}, c);
    const Vec3 exact = to_srgb * q.integrate(whole);
    Vec3 in_gltf{}, in_blender{};
    for (std::size_t ch = 0; ch < 3; ++ch) {
      const double coat = schlick(0.04, c);
      in_gltf[ch] = coat + (1 - coat) * schlick(field(gltf, "baseColorFactor").values[ch], c);
      const double f0 = field(blender, "Base Color").values[ch], own = clear_fresnel(n, c);
      const double tint = field(blender, "Specular Tint").values[ch];
      const double a = (schlick(f0, 1.0 / 7) - tint_at(f0, tint)) / (std::pow(6.0 / 7, 6) / 7);
      in_blender[ch] = own + (1 - own) * (schlick(f0, c) - a * c * std::pow(1 - c, 6));
    }
    const double weight = std::sin(angle) * c;
    const double off = delta_e2000(cut_lab(in_gltf), cut_lab(exact));
    mean_gltf += weight * off;
    mean_blender += weight * delta_e2000(cut_lab(in_blender), cut_lab(exact));
    weights += weight;
    worst = std::max(worst, off);
  }
  CHECK(gltf.error->mean == Approx(mean_gltf / weights).margin(2e-4));
  CHECK(gltf.error->largest == Approx(worst).margin(2e-4));
  CHECK(blender.error->mean == Approx(mean_blender / weights).margin(2e-4));
}

TEST_CASE("every target tells its error under a coat, or why there is none") {
  for (const char* const base : {"gold", "glass_bk7"}) {
    const ExportSurface s = coated_surface(base, "water:2mm");
    CHECK(s.seen);
    for (const EngineTarget& target : engine_targets()) {
      const EngineValues v = values_for(target.id.data(), s);
      INFO(base << " " << target.id);
      CHECK(v.error.has_value() == v.error_reason.empty());
      // The spectra are those of the base alone, so that renderers of spectra get colours too.
      const bool none = target.formula.empty();
      CHECK(v.error.has_value() != none);
    }
  }
  CHECK(!contains(copy_text(values_for("pbrt", coated_surface("gold", "1.5"))), "spectrum eta"));
  // A body of its own under a coat: MaterialX's graph darkens it as it is published, Adobe's is not computed.
  ExportWishes painted;
  painted.diffuse = LinearRgb{0.5, 0.2, 0.1};
  const ExportSurface plastic = *coated_answer("pmma", "1.4", painted).surface;
  CHECK(values_for("openpbr", plastic).error);
  CHECK(contains(values_for("openpbr-adobe", plastic).error_reason, "darkens a diffuse body"));
}

TEST_CASE("targets without a coat are given the whole, and told so") {
  const ExportSurface s = coated_surface("gold", "1.5");
  for (const EngineTarget& target : engine_targets()) {
    INFO(target.id);
    const EngineValues v = engine_values(target, s);
    const bool told = !v.notes.empty() && contains(v.notes.front(), "no field for the coat 1.5");
    CHECK(told == !target.has_coat);
  }
  CHECK(field(values_for("linear", s), "F0").values ==
        std::vector{s.coat->whole.linear.r, s.coat->whole.linear.g, s.coat->whole.linear.b});
  CHECK(field(values_for("unreal", s), "Base Color").values[1] == s.coat->whole.linear.g);
  const auto edge = field(values_for("glsl", s), "f82").values;
  CHECK(edge[2] == s.coat->whole.f82->b);
}

TEST_CASE(
    "a clear body keeps the index that bends light, and a coat of its own index leaves its surface alone") {
  const ExportSurface glass = coated_surface("fused_silica", "fused_silica");
  REQUIRE(glass.clear);
  ExportSurface bare = glass;
  bare.coat.reset();
  const double n = number_of(values_for("openpbr", bare), "specular_ior");
  const EngineValues gltf = values_for("gltf", glass), blender = values_for("blender", glass),
                     open = values_for("openpbr", glass);
  CHECK(number_of(gltf, "KHR_materials_ior.ior") == Approx(n).epsilon(1e-9));
  CHECK(number_of(blender, "IOR") == Approx(n).epsilon(1e-9));
  CHECK(number_of(open, "specular_ior") == Approx(n).epsilon(1e-9));
  CHECK(number_of(open, "coat_darkening") == 0);
  for (const double c : field(gltf, "KHR_materials_specular.specularColorFactor").values)
    CHECK(c == Approx(0).margin(1e-6));
  // OpenPBR compares the two indices itself; the whole is that of bare glass.
  const double coat = number_of(open, "coat_ior"), s = std::pow((coat - 1) / (coat + 1), 2);
  const double below = std::pow((n - coat) / (n + coat), 2);
  CHECK(s + (1 - s) * below == Approx(glass.f0.g).margin(5e-4));
  const ExportSurface on_diamond = coated_surface("diamond", "1.5");
  const EngineValues v = values_for("gltf", on_diamond);
  const double ior = number_of(v, "KHR_materials_ior.ior"), f0 = std::pow((ior - 1) / (ior + 1), 2);
  CHECK(ior == Approx(2.42).margin(0.01));
  CHECK(0.04 + 0.96 * f0 * field(v, "KHR_materials_specular.specularColorFactor").values[1] ==
        Approx(on_diamond.coat->whole.linear.g).epsilon(1e-9));
  CHECK(number_of(values_for("unreal", on_diamond), "Refraction (Index of Refraction)") ==
        Approx(2.42).margin(0.01));
}

TEST_CASE("the Khronos validator takes documents with coats, and the form without one has the whole") {
  const std::vector<ExportSurface> surfaces{coated_surface("gold", "1.5"), coated_surface("diamond", "pmma"),
                                            coated_surface("copper", "water:2mm")};
  const TempFolder temp;
  std::vector<std::string> files;
  for (const auto form : {GltfMaterialForm::metal_rough, GltfMaterialForm::specular_glossiness}) {
    std::vector<Changes> changes;
    const std::string text = gltf_document(surfaces, form, GltfContainer::gltf, Fit::clamp, changes);
    CHECK(contains(text, "KHR_materials_clearcoat") == (form == GltfMaterialForm::metal_rough));
    CHECK(contains(text, "\"coat\": {\"n\": 1.5, \"f0_under\""));
    files.push_back(temp.file(std::to_string(files.size()) + ".gltf"));
    spit(files.back(), text);
  }
  const auto messages = gltf_messages(temp.path(), files);
  if (!messages) WARN("no node with gltf-validator (NODE_PATH): what is written is not validated");
  CHECK(messages.value_or("") == "");
  std::vector<Changes> changes;
  const std::string text = material_x(surfaces, Fit::clamp, changes);
  CHECK(contains(text, "<input name=\"coat_ior\" type=\"float\" value=\"1.5\" />"));
  CHECK(contains(text, "<input name=\"coat_weight\" type=\"float\" value=\"1\" />"));
}

TEST_CASE("coats of exports that cannot be are refused with one line") {
  CHECK(contains(error_of([] { (void)coated_answer("spectralon", "1.5"); }),
                 "tells nothing of what is reflected under a coat"));
  ExportWishes wishes;
  wishes.coat = coat_setting("1.5", known);
  F0Options wet;
  wet.outside = outside_medium(library(), "water", "place", {});
  CHECK(contains(error_of([&] { validate(wishes, wet); }), "coats of targets are in air"));
  CHECK(contains(error_of([&] { (void)coat_option("1.5", known, {}, true); }), "expected one of them"));
  CHECK(error_of([&] { validate(ExportWishes{}, wet); }) == "");
}
