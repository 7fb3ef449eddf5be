// SPDX-License-Identifier: Apache-2.0
#include "core/material/stack.h"

#include <catch2/catch.hpp>
#include <complex>
#include <numbers>
#include <set>

#include "core/film/stack.h"
#include "core/material/f0/f0_data.h"
#include "core/material/f0/f0_steps.h"
#include "core/material/json.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Material material_of_stack(std::string_view text) {
  auto found = find_material(library(), text);
  REQUIRE(found);
  return std::move(found->answer.material);
}

std::string stack_refusal(std::string_view text) {
  return error_of([&] { (void)find_material(library(), text); });
}

const Stack& preferred_stack(const Material& material) {
  return std::get<Stack>(material.preferred_dataset().optics);
}

F0Result stack_f0(std::string_view text, const F0Options& options = {}) {
  return F0Solver(options).solve(material_of_stack(text).preferred_dataset().optics);
}

double farthest(const LinearRgb& a, const LinearRgb& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

TEST_CASE("a stack's media, class and datasets are those of its text") {
  const Material material = material_of_stack("anatase:40nm/titanium");
  CHECK(material.material_class == "metal");
  CHECK(material.name == "anatase:40nm/titanium");
  const Stack& stack = preferred_stack(material);
  REQUIRE(stack.media.size() == 2);
  CHECK(stack.media[0].id == "anatase");
  CHECK(stack.media[stack.base].id == "titanium");
  const std::string preferred = test::material("anatase").preferred_dataset().id + "+" +
                                test::material("titanium").preferred_dataset().id;
  CHECK(material.preferred_dataset().id == preferred);
  CHECK(contains(source_line(material.preferred_dataset()), "titanium: "));
  // Each other dataset of n and k takes the place of the preferred one once.
  std::size_t others = 0;
  for (const char* id : {"anatase", "titanium"})
    for (const Dataset& each : test::material(id).datasets)
      others += std::holds_alternative<OpticalConstants>(each.optics) ? 1 : 0;
  CHECK(material.datasets.size() == 1 + others - 2);
  std::set<std::string> ids;
  for (const Dataset& each : material.datasets) ids.insert(each.id);
  CHECK(ids.size() == material.datasets.size());
  // A text that names its datasets has no others, and what is written of one finds it again.
  for (const Dataset& each : material.datasets) {
    const Material again = material_of_stack(std::get<Stack>(each.optics).text);
    if (&each == &material.datasets[0]) continue;
    REQUIRE(again.datasets.size() == 1);
    CHECK(again.datasets[0].id == each.id);
    CHECK(std::get<Stack>(again.datasets[0].optics) == std::get<Stack>(each.optics));
  }
}

TEST_CASE("a layer without thickness, or of the outside medium, changes nothing") {
  const F0Result bare = F0Solver({}).solve(test::material("titanium").preferred_dataset().optics);
  CHECK(farthest(stack_f0("anatase:0nm/titanium").linear, bare.linear) < 1e-13);
  CHECK(farthest(*stack_f0("anatase:0nm/titanium").f82, *bare.f82) < 1e-13);
  F0Options wet;
  wet.outside = outside_medium(library(), "water", "place", {});
  const F0Result under = F0Solver(wet).solve(test::material("titanium").preferred_dataset().optics);
  CHECK(farthest(stack_f0("water:300nm/titanium", wet).linear, under.linear) < 1e-12);
}

TEST_CASE("the reflectance of one film is Airy's formula, at normal incidence of complex numbers") {
  const Material material = material_of_stack("anatase:40nm/titanium");
  const Stack& stack = preferred_stack(material);
  const F0Setup setup = f0_setup({});
  F0Spectra room;
  room.resize(grid_size);
  Stopwatch watch(false);
  F0Timing ignored;
  REQUIRE(reflectance_at(setup, stack, setup.quadrature, room, watch, ignored).empty());
  std::vector<double> n(grid_size), k(grid_size), nb(grid_size), kb(grid_size);
  index_at(setup, stack.media[0].constants, setup.quadrature, n);
  index_at(setup, stack.media[1].constants, setup.quadrature, nb);
  resample(*stack.media[0].constants.k, Interpolation::linear, setup.quadrature.wavelength_nm, k);
  resample(*stack.media[1].constants.k, Interpolation::linear, setup.quadrature.wavelength_nm, kb);
  using Number = std::complex<double>;
  for (std::size_t i = 0; i < grid_size; ++i) {
    const Number film(n[i], k[i]), base(nb[i], kb[i]);
    const Number upper = (1.0 - film) / (1.0 + film), lower = (film - base) / (film + base);
    const Number way =
        std::exp(Number(0, 4 * std::numbers::pi * 40 / setup.quadrature.wavelength_nm[i]) * film);
    const double r = std::norm((upper + lower * way) / (1.0 + upper * lower * way));
    CHECK(room.r0[i] == Approx(r).epsilon(1e-12));
  }
}

TEST_CASE("a thick layer has no fringes, and a thick coherent one says that they are too narrow") {
  const F0Result thick = stack_f0("water:2mm/copper"), thicker = stack_f0("water:2.001mm/copper");
  CHECK(farthest(thick.linear, thicker.linear) < 1e-3);
  CHECK_FALSE(thick.flags.has(Flag::unresolved_fringes));
  CHECK(stack_f0("water:12um:coherent/copper").flags.has(Flag::unresolved_fringes));
  CHECK_FALSE(stack_f0("water:1um/copper").flags.has(Flag::unresolved_fringes));
  F0Options wide;
  wide.method = Method::nm10;
  CHECK(stack_f0("water:1um/copper", wide).flags.has(Flag::unresolved_fringes));
}

TEST_CASE("all ways to sum agree on a film, and coverage is the least of all media") {
  F0Options exact;
  exact.method = Method::exact;
  CHECK(farthest(stack_f0("anatase:200nm/titanium", exact).linear,
                 stack_f0("anatase:200nm/titanium").linear) < 1e-4);
  const F0Result film = stack_f0("anatase:200nm/titanium");
  const F0Result anatase = F0Solver({}).solve(test::material("anatase").preferred_dataset().optics);
  CHECK(film.coverage.least() <= anatase.coverage.least());
  CHECK(film.zone.has_value());
  CHECK(film.f82.has_value());
}

TEST_CASE("the colours of anodised titanium are those that are seen: straw, then blue") {
  const LinearRgb straw = stack_f0("anatase:25nm/titanium").srgb_linear;
  CHECK(straw.r > straw.b);
  const LinearRgb blue = stack_f0("anatase:50nm/titanium").srgb_linear;
  CHECK(blue.b > blue.r);
}

TEST_CASE(
    "the stacks of the library have a colour, F82, and a thickness with its source or the word nominal") {
  std::size_t stacks = 0;
  for (std::size_t i = 0; i < library().ids().size(); ++i) {
    if (!std::holds_alternative<Stack>(library().as_filed(i).preferred_dataset().optics)) continue;
    ++stacks;
    const Material material = library().at(i);
    INFO(material.id);
    CHECK(material.group == "film");
    const Stack& stack = preferred_stack(material);
    REQUIRE(stack.is_open());
    const FoundDataset base = library_part(library(), stack.media[stack.base].id, "base").found;
    CHECK(material.material_class == base.material.material_class);
    const F0Result result = F0Solver({}).solve(stack);
    CHECK(result.refusal == "");
    CHECK(result.f82.has_value());
    const Dataset& dataset = material.preferred_dataset();
    CHECK((contains(dataset.sample, "nominal") || contains(dataset.sample, "of 550 nm")));
  }
  CHECK(stacks >= 12);
}

TEST_CASE("each fault of a stack's names has one line") {
  CHECK(contains(stack_refusal("anatse:40nm/titanium"),
                 "layer 1: no material of the library is called anatse"));
  CHECK(contains(stack_refusal("anatse:40nm/titanium"), "anatase"));
  CHECK(contains(stack_refusal("anatase:40nm/unobtainium"),
                 "base: no material of the library is called unobtainium"));
  CHECK(contains(stack_refusal("anatase/nobody:40nm/titanium"), "anatase: has no dataset nobody"));
  CHECK(contains(stack_refusal("polystyrene:?nm/silicon"),
                 "layer 1: polystyrene has an unknown thickness; expected a number in place of ?"));
  CHECK(contains(stack_refusal("spectralon:40nm/titanium"),
                 "has reflectance data only; expected a medium of n and k"));
  std::string many;
  for (int i = 0; i < 10000; ++i) many += "water:1nm/";
  CHECK(contains(stack_refusal(many + "gold"), "more than 1000 layers"));
  CHECK(stack_refusal(many + "gold").size() < 300);
}

TEST_CASE("data that do not cover the visible are refused with the medium's name") {
  Stack stack = preferred_stack(material_of_stack("anatase:40nm/titanium"));
  stack.media[0].constants.n = Spectrum{{500, 600}, {2, 2}};
  const F0Result result = F0Solver({}).solve(stack);
  CHECK(contains(result.refusal, "anatase/"));
  CHECK(contains(result.refusal, "of the Y weight (500-600 nm)"));
  const F0Result closed = F0Solver({}).solve(Stack{"anatase:40nm/titanium", {}, {}, 0});
  CHECK(contains(closed.refusal, "were not looked up"));
}

TEST_CASE("a layer gets another thickness by its number from the outside") {
  const Stack stack = preferred_stack(material_of_stack("water:1mm/anatase:40nm/titanium"));
  CHECK(with_thickness(stack, 2, 50).layers[1].thickness_nm == 50);
  CHECK(contains(error_of([&] { (void)with_thickness(stack, 3, 50); }),
                 "has no layer 3; expected a layer from 1 to 2, the outermost being 1"));
  CHECK(contains(error_of([&] { (void)with_thickness(stack, 0, 50); }), "has no layer 0"));
}

TEST_CASE("a material file with a stack reads back as it is written, open or not") {
  const std::string text = R"({"schema": "etak-material/1", "id": "blue", "name": "Blue", "aliases": [],
    "preferred": "nominal", "preferred_reason": "", "datasets": [{"id": "nominal", "quantity": "stack",
    "sample": "", "citation": {"authors": [], "title": "t", "published_in": "", "licence": "CC0-1.0", "via": ""},
    "stack": "anatase:50nm/titanium"}]})";
  Material material = parse_material(text, "blue.json");
  CHECK_FALSE(preferred_stack(material).is_open());
  CHECK(parse_material(format_material(material), "again") == material);
  const auto part = [](std::string_view name, const std::string& place) {
    return library_part(library(), name, place);
  };
  open_stacks(material, "blue.json", part);
  CHECK(material.material_class == "metal");
  CHECK(material.preferred_dataset().id == "nominal");
  CHECK(material.datasets.size() > 3);
  Material again = parse_material(format_material(material), "again");
  open_stacks(again, "again", part);
  REQUIRE(again.datasets.size() == material.datasets.size());
  for (std::size_t i = 0; i < again.datasets.size(); ++i)
    CHECK(std::get<Stack>(again.datasets[i].optics) == std::get<Stack>(material.datasets[i].optics));
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string bad = text;
    bad.replace(bad.find(from), from.size(), to);
    return error_of([&] { (void)parse_material(bad, "blue.json"); });
  };
  CHECK(contains(broken("50nm", "50"), "blue.json#/datasets/0/stack layer 1: thickness 50 has no unit"));
  CHECK(contains(broken("\"quantity\": \"stack\"", "\"quantity\": \"n\""), "blue.json#/datasets/0/quantity"));
  CHECK(contains(broken("\"stack\": \"ana", "\"unit\": \"nm\", \"stack\": \"ana"), "data beside a stack"));
}
