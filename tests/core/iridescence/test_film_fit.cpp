// SPDX-License-Identifier: Apache-2.0
// Fitted numbers of films.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/iridescence/parameters.h"
#include "core/material/stack.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Stack stack_of(const std::string& text) {
  const Material material = stack_material(text, [](std::string_view name, const std::string& place) {
    return library_part(library(), name, place);
  });
  return std::get<Stack>(material.preferred_dataset().optics);
}

FilmParameters parameters_of(const std::string& text, FilmBase base = FilmBase::metal) {
  return film_parameters(stack_of(text), base, {}, film_forms());
}

bool in_ranges(const FilmForm& form, const FilmNumbers& numbers) {
  for (std::size_t i = 0; i < form.numbers.size(); ++i)
    if (!(numbers[i] >= form.numbers[i].least && numbers[i] <= form.numbers[i].most)) return false;
  return true;
}

}  // namespace

TEST_CASE("what a form itself shows is found again to a hundredth of dE2000 or near it") {
  const FilmNumbers planted{0.62, 0.55, 0.4, 0.8, 1.9, 180};
  const FilmForm& form = *film_form("gltf");
  const FilmTruth truth = film_truth([&](double cosine) { return form.seen(planted, cosine); });
  CHECK(film_error(form, planted, truth) == FilmError{});
  const FilmNumbers found = fitted_film(form, truth, {0.5, 0.5, 0.5, 1, 1.5, 240}, 1.9 * 180);
  CHECK(film_error(form, found, truth).mean < 0.1);
}

TEST_CASE("angles of a film's error count by cos sin, and normal incidence is told by itself") {
  const FilmForm& form = *film_form("f82");
  const FilmNumbers black{0, 0, 0, 0, 0, 0}, white{1, 1, 1, 1, 1, 1};
  const FilmTruth truth = film_truth([&](double cosine) { return form.seen(white, cosine); });
  REQUIRE(truth.cosines.size() == 15);
  CHECK(truth.cosines.back() == Approx(std::cos(84 * std::numbers::pi / 180)));
  CHECK(truth.weights.front() == 0);
  double sum = 0;
  for (const double weight : truth.weights) sum += weight;
  CHECK(sum == Approx(1));
  CHECK(film_error(form, black, truth).normal == Approx(100));  // black beside white
}

TEST_CASE("fitted numbers stay in their ranges and miss no more than honest ones, for every form") {
  for (const char* text : {"anatase:40nm/titanium", "silicon_nitride:230nm/gold", "hematite:25nm/iron"}) {
    const FilmParameters all = parameters_of(text);
    CHECK(all.no_honest.empty());
    for (const FilmInForm& each : all.forms) {
      INFO(text << ", " << each.form->id);
      CHECK(each.form->metal);
      CHECK(in_ranges(*each.form, each.fitted.numbers));
      REQUIRE(each.honest);
      CHECK(in_ranges(*each.form, each.honest->numbers));
      CHECK(each.fitted.error.mean <= each.honest->error.mean);
      CHECK(each.fitted.error.mean < 5);
    }
  }
}

TEST_CASE("anodised titanium is missed by far by honest numbers, and shown by the fitted ones of glTF") {
  const FilmParameters all = parameters_of("anatase:60nm/titanium");
  const FilmInForm& gltf = *all.in("gltf");
  CHECK(gltf.honest->numbers[3] == 1);
  CHECK(gltf.honest->numbers[5] == 60);
  CHECK(gltf.honest->error.mean > 20);
  CHECK(gltf.fitted.error.mean < 3);
  CHECK_FALSE(gltf.use_honest());
  CHECK(gltf.advice().starts_with("Use the fitted numbers: "));
}

TEST_CASE("magnesium fluoride on glass is shown by honest numbers nearly as well as by fitted ones") {
  const FilmParameters all = parameters_of("magnesium_fluoride:100nm/fused_silica", FilmBase::dielectric);
  CHECK(all.in("openpbr-metal") == nullptr);
  const FilmInForm& gltf = *all.in("gltf");
  CHECK(gltf.honest->error.mean < 2);
  CHECK(all.in("openpbr-dielectric")->honest->numbers[4] == Approx(1.378).margin(0.01));
}

TEST_CASE("fits of films are the same when they are repeated") {
  const Stack stack = stack_of("tantala:120nm/niobium");
  const FilmForm* const form = film_form("gltf");
  const FilmParameters a = film_parameters(stack, FilmBase::metal, {}, {&form, 1}),
                       b = film_parameters(stack, FilmBase::metal, {}, {&form, 1});
  CHECK(a.forms[0].fitted.numbers == b.forms[0].fitted.numbers);
}

TEST_CASE("several layers, a coat, an absorbing film and one that is too thick are fitted and told") {
  const FilmForm* const form = film_form("gltf");
  const auto parameters = [&](const char* text) {
    return film_parameters(stack_of(text), FilmBase::metal, {}, {&form, 1});
  };
  const FilmParameters two = parameters("fused_silica:80nm/anatase:40nm/aluminum");
  CHECK(two.no_honest == "the forms have one film, and the stack has 2 layers");
  CHECK_FALSE(two.forms[0].honest);
  CHECK(two.forms[0].fitted.error.mean < 6);
  CHECK(parameters("water:2mm/copper").no_honest ==
        "the layer is too thick for colours of interference: it is a coat");
  const FilmParameters dark = parameters("hematite:25nm/iron");
  REQUIRE(dark.notes.size() == 1);
  CHECK(dark.notes[0].starts_with("hematite absorbs (k up to "));
  const FilmParameters thick = parameters("fused_silica:1500nm/aluminum");
  CHECK(thick.notes.empty());
  CHECK(thick.forms[0].note ==
        "glTF KHR_materials_iridescence is fitted up to 1200 nm, and the film has 1500 nm");
}

TEST_CASE("no film of a renderer lies in water") {
  F0Options options;
  options.outside = {"water", 1.333};
  CHECK_THROWS_WITH(
      film_parameters(stack_of("anatase:40nm/titanium"), FilmBase::metal, options, film_forms()),
      Catch::Contains("films of renderers lie in air"));
}
