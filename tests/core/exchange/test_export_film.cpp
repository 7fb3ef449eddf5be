// SPDX-License-Identifier: Apache-2.0
// Exports of stacks: the fields of each target's film, their units, and the errors that are told, computed again from the
// fields alone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/exchange/export_input.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/fresnel/fresnel.h"
#include "core/material/seen_stack.h"
#include "core/material/stack.h"
#include "tests/core/exchange/field.h"
#include "tests/core/material/library_support.h"
#include "tests/gltf_judge.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const LibraryWhenAsked whole_library = []() -> const MaterialLibrary& { return library(); };

ExportSurface filmed_surface(const std::string& name) {
  InputNames names;
  names.names = {name};
  ExportAnswer answer = export_answer(find_inputs(names, whole_library, 1).at(0), {}, F0Solver({}), {});
  REQUIRE(answer.refusal == "");
  return *answer.surface;
}

EngineValues film_values(const char* target, const ExportSurface& surface) {
  return engine_values(*engine_target(target), surface);
}

double number_in(const std::vector<EngineField>& fields, std::string_view name) {
  for (const EngineField& each : fields)
    if (each.name == name) return each.values.at(0);
  FAIL("no field " << name);
  return 0;
}

std::vector<double> color_in(const std::vector<EngineField>& fields, std::string_view name) {
  for (const EngineField& each : fields)
    if (each.name == name) return each.values;
  FAIL("no field " << name);
  return {};
}

SeenStack exact_stack(const std::string& name) {
  const Material material = stack_material(name, [](std::string_view part, const std::string& place) {
    return library_part(library(), part, place);
  });
  return SeenStack(std::get<Stack>(material.preferred_dataset().optics));
}

FilmTruth film_truth_of(const std::string& name) {
  const SeenStack seen = exact_stack(name);
  return film_truth([&](double cosine) { return seen(cosine); });
}

const std::string iridescence_prefix = "KHR_materials_iridescence.iridescence";

}  // namespace

TEST_CASE("glTF's film of anodised titanium is in nanometres, and its fields miss what is told of them") {
  const EngineValues values = film_values("gltf", filmed_surface("anatase:40nm/titanium"));
  REQUIRE(values.film);
  CHECK_FALSE(values.film->use_honest);
  CHECK(values.fields == values.film->fitted.fields);
  REQUIRE(values.film->honest);
  CHECK(number_in(values.film->honest->fields, iridescence_prefix + "ThicknessMaximum") == 40);
  CHECK(number_in(values.film->honest->fields, iridescence_prefix + "Factor") == 1);
  CHECK(values.film->honest->error.mean > 10);
  CHECK(values.film->fitted.error.mean < 3);
  const FilmTruth truth = film_truth_of("anatase:40nm/titanium");
  for (const EngineFilm::Side& side : {*values.film->honest, values.film->fitted}) {
    const auto base = color_in(side.fields, "baseColorFactor");
    const FilmNumbers numbers{base[0],
                              base[1],
                              base[2],
                              number_in(side.fields, iridescence_prefix + "Factor"),
                              number_in(side.fields, iridescence_prefix + "Ior"),
                              number_in(side.fields, iridescence_prefix + "ThicknessMaximum")};
    CHECK(number_in(side.fields, iridescence_prefix + "ThicknessMinimum") == numbers[5]);
    const FilmError error = film_error(*film_form("gltf"), numbers, truth);
    CHECK(error.mean == Approx(side.error.mean).margin(1e-9));
    CHECK(error.largest == Approx(side.error.largest).margin(1e-9));
    CHECK(error.normal == Approx(side.error.normal).margin(1e-9));
  }
}

TEST_CASE("OpenPBR's film of anodised titanium is in micrometres, and its fields miss what is told of them") {
  const EngineValues values = film_values("openpbr", filmed_surface("anatase:40nm/titanium"));
  REQUIRE(values.film);
  CHECK(number_in(values.film->honest->fields, "thin_film_thickness") == Approx(0.04));
  const auto& fitted = values.film->fitted.fields;
  const auto base = color_in(fitted, "base_color"), tint = color_in(fitted, "specular_color");
  const FilmNumbers numbers{base[0],
                            base[1],
                            base[2],
                            tint[0],
                            tint[1],
                            tint[2],
                            number_in(fitted, "thin_film_ior"),
                            1000 * number_in(fitted, "thin_film_thickness"),
                            number_in(fitted, "thin_film_weight")};
  const FilmError error =
      film_error(*film_form("openpbr-metal"), numbers, film_truth_of("anatase:40nm/titanium"));
  CHECK(error.mean == Approx(values.film->fitted.error.mean).margin(1e-6));
}

TEST_CASE("a film on glass goes to glTF by index and specular colour, and to OpenPBR's dielectric") {
  const ExportSurface surface = filmed_surface("magnesium_fluoride:100nm/fused_silica");
  CHECK(surface.kind == SurfaceKind::dielectric);
  const EngineValues gltf = film_values("gltf", surface);
  REQUIRE(gltf.film);
  const auto tint = color_in(gltf.film->fitted.fields, "KHR_materials_specular.specularColorFactor");
  const double ior = number_in(gltf.film->fitted.fields, "KHR_materials_ior.ior");
  const double f0 = std::pow((ior - 1) / (ior + 1), 2);
  const FilmNumbers& numbers = surface.film->fits->in("gltf")->fitted.numbers;
  for (std::size_t c = 0; c < 3; ++c) CHECK(f0 * tint[c] == Approx(numbers[c]).margin(1e-9));
  const EngineValues openpbr = film_values("openpbr", surface);
  CHECK(number_in(openpbr.film->honest->fields, "specular_ior") == Approx(1.46).margin(0.01));
  CHECK(number_in(openpbr.film->honest->fields, "thin_film_ior") == Approx(1.378).margin(0.01));
}

TEST_CASE("targets without a film are given F0 of the whole, and say so") {
  const ExportSurface surface = filmed_surface("anatase:40nm/titanium");
  const EngineValues values = film_values("unreal", surface);
  CHECK_FALSE(values.film);
  CHECK(values.notes.back() == "no film is written: F0 and F82 are those of the whole");
  const SeenStack seen = exact_stack("anatase:40nm/titanium");
  CHECK(field(values, "Base Color").values[0] == Approx(seen(1)[0]).margin(1e-9));
}

TEST_CASE("several layers have no honest numbers in a target, and fitted ones") {
  const ExportSurface surface = filmed_surface("fused_silica:80nm/anatase:40nm/aluminum");
  const EngineValues values = film_values("gltf", surface);
  REQUIRE(values.film);
  CHECK_FALSE(values.film->honest);
  const std::string json = export_json({{surface, "x", {values}}}, Fit::clamp, "p");
  CHECK(contains(json, "\"honest\": null"));
  CHECK(contains(json, "\"use\": \"fitted\""));
}

TEST_CASE("files of stacks have the films, and Khronos' validator finds nothing in them") {
  const std::vector<ExportSurface> surfaces{filmed_surface("anatase:40nm/titanium"),
                                            filmed_surface("magnesium_fluoride:100nm/fused_silica")};
  std::vector<Changes> changes;
  const std::string mtlx = material_x(surfaces, Fit::clamp, changes);
  CHECK(count_of(mtlx, "<input name=\"thin_film_thickness\" type=\"float\"") == 2);
  const std::string gltf =
      gltf_document(surfaces, GltfMaterialForm::metal_rough, GltfContainer::gltf, Fit::clamp, changes);
  CHECK(count_of(gltf, "\"KHR_materials_iridescence\": {") == 2);
  const TempFolder folder;
  const std::string file = folder.file("films.gltf");
  spit(file, gltf);
  if (const auto messages = gltf_messages(folder.path(), {file})) CHECK(*messages == "");
}

TEST_CASE("a film in another space or under water is refused in one line") {
  const auto refusal = [](const F0Options& options) {
    InputNames names;
    names.names = {"anatase:40nm/titanium"};
    return export_answer(find_inputs(names, whole_library, 1).at(0), {}, F0Solver(options), {}).refusal;
  };
  F0Options space;
  space.space = RgbSpace::acescg;
  CHECK(contains(refusal(space), "films are fitted in linear sRGB"));
  F0Options water;
  water.outside = {"water", 1.333};
  CHECK(contains(refusal(water), "films of renderers lie in air"));
}

TEST_CASE("each target has the film's thickness in its own unit") {
  const ExportSurface surface = filmed_surface("anatase:40nm/titanium");
  const auto honest = [&](const char* target, std::string_view name) {
    return number_in(film_values(target, surface).film->honest->fields, name);
  };
  CHECK(honest("gltf", iridescence_prefix + "ThicknessMaximum") == 40);
  CHECK(honest("conductor_bsdf", "thinfilm_thickness") == 40);
  CHECK(honest("generalized_schlick_bsdf", "thinfilm_thickness") == 40);
  CHECK(honest("openpbr", "thin_film_thickness") == Approx(0.04));
  CHECK(honest("openpbr-adobe", "thin_film_thickness") == Approx(0.04));
}

TEST_CASE(
    "MaterialX's nodes and Adobe's OpenPBR miss a stack by what is told, computed from their fields alone") {
  const ExportSurface surface = filmed_surface("anatase:40nm/titanium");
  const FilmTruth truth = film_truth_of("anatase:40nm/titanium");
  const auto misses = [&](const char* form, const EngineFilm::Side& side,
                          std::initializer_list<const char*> names, double last) {
    FilmNumbers numbers{};
    std::size_t at = 0;
    for (const char* name : names)
      for (const double value : color_in(side.fields, name)) numbers[at++] = value;
    numbers[at - 1] *= last;
    CHECK(film_error(*film_form(form), numbers, truth).mean == Approx(side.error.mean).margin(1e-6));
  };
  const EngineFilm conductor = *film_values("conductor_bsdf", surface).film;
  const EngineFilm schlick = *film_values("generalized_schlick_bsdf", surface).film;
  const EngineFilm adobe = *film_values("openpbr-adobe", surface).film;
  for (const bool fitted : {false, true}) {
    const auto side = [&](const EngineFilm& film) { return fitted ? film.fitted : *film.honest; };
    misses("conductor_bsdf", side(conductor), {"ior", "extinction", "thinfilm_ior", "thinfilm_thickness"}, 1);
    misses("generalized_schlick_bsdf", side(schlick),
           {"color0", "color82", "thinfilm_ior", "thinfilm_thickness"}, 1);
  }
  CHECK(conductor.fitted.error.mean < 2);
  CHECK(adobe.fitted.error.mean < adobe.honest->error.mean);
  CHECK(color_in(conductor.fitted.fields, "roughness").size() == 1);
}

TEST_CASE("every target with a film tells honest and fitted fields, their errors, and which to use") {
  for (const char* stack : {"anatase:40nm/titanium", "magnesium_fluoride:100nm/fused_silica"}) {
    const ExportSurface surface = filmed_surface(stack);
    for (const EngineTarget& target : engine_targets()) {
      INFO(stack << " in " << target.id);
      const EngineValues values = engine_values(target, surface);
      CHECK(values.film.has_value() == !target.film_form(surface.kind).empty());
      if (!values.film) continue;
      REQUIRE(values.film->honest);
      CHECK(values.fields == (values.film->use_honest ? *values.film->honest : values.film->fitted).fields);
      const std::string json = export_json({{surface, "x", {values}}}, Fit::clamp, "p");
      for (const char* member : {"\"film\": {", "\"honest\": {", "\"fitted\": {",
                                 "\"mean\": ", "\"max\": ", "\"normal\": ", "\"use\": \""})
        CHECK(contains(json, member));
    }
  }
}

TEST_CASE("a film thicker than a target takes is fitted within its range, and told") {
  const EngineValues values = film_values("gltf", filmed_surface("fused_silica:2um/silicon"));
  CHECK(
      std::ranges::find(values.notes,
                        "glTF KHR_materials_iridescence is fitted up to 1200 nm, and the film has 2000 nm") !=
      values.notes.end());
  CHECK(number_in(values.film->honest->fields, iridescence_prefix + "ThicknessMaximum") == 1200);
}

TEST_CASE("a film that absorbs is fitted, and told") {
  const ExportSurface surface = filmed_surface("hematite:25nm/iron");
  CHECK(std::ranges::any_of(
      surface.notes, [](const std::string& note) { return note.starts_with("hematite absorbs (k up to"); }));
  CHECK(film_values("gltf", surface).film->fitted.error.mean < 3);
}

TEST_CASE("a film on glass in a node for metals is F0 and F82 of the whole, and told") {
  const EngineValues values =
      film_values("conductor_bsdf", filmed_surface("magnesium_fluoride:100nm/fused_silica"));
  CHECK_FALSE(values.film);
  CHECK(values.notes.front() == "the node is made for metals: a dielectric has its surface alone");
  CHECK(values.notes.back() == "no film is written: F0 and F82 are those of the whole");
  const Vec3 whole = exact_stack("magnesium_fluoride:100nm/fused_silica")(1);
  CHECK(f64::f0(field(values, "ior").values[1], field(values, "extinction").values[1]) ==
        Approx(whole[1]).margin(1e-6));
}

TEST_CASE("a coat over layers is a layer: targets with a film are fitted to the whole, others get its F0") {
  const ExportSurface surface = filmed_surface("pmma:2mm/anatase:40nm/titanium");
  const EngineValues gltf = film_values("gltf", surface);
  CHECK_FALSE(gltf.film->honest);
  CHECK(gltf.film->fitted.error.mean < 5);
  CHECK(std::ranges::find(
            surface.notes,
            "films of renderers are fitted: the forms have one film, and the stack has 2 layers") !=
        surface.notes.end());
  const Vec3 whole = exact_stack("pmma:2mm/anatase:40nm/titanium")(1);
  CHECK(field(film_values("unreal", surface), "Base Color").values[0] == Approx(whole[0]).margin(1e-9));
}
