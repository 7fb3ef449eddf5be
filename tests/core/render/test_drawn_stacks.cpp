// SPDX-License-Identifier: Apache-2.0
// Stacks of layers in pictures: the curve of their F against the exact stack.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/color/delta_e.h"
#include "core/color/luminance.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/material/seen_stack.h"
#include "core/material/stack.h"
#include "core/render/environment.h"
#include "core/render/reference.h"
#include "core/render/typed.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const MaterialLibrary& film_library() {
  static const MaterialLibrary all = MaterialLibrary::builtin();
  return all;
}

Material film_material(const std::string& text) {
  return stack_material(text, [](std::string_view name, const std::string& place) {
    return library_part(film_library(), name, place);
  });
}

SurfaceValues film_surface(const Material& material) {
  return surface_of(material, material.preferred_dataset(), {0, 0, 0}, 0.6);
}

// The largest CIEDE2000 between the surface's curve and the exact stack, at angles that the fit does not know.
double worst_of_curve(const Material& material) {
  const SurfaceValues surface = film_surface(material);
  const SeenStack exact(std::get<Stack>(material.preferred_dataset().optics));
  double worst = 0;
  for (int i = 0; i < 89; ++i) {
    const double cosine = std::cos((i + 0.37) * 3.14159265358979 / 180);
    worst = std::max(worst,
                     delta_e2000(to_lab(to_rgb(surface.curve->at(cosine))), to_lab(to_rgb(exact(cosine)))));
  }
  CHECK(worst <= surface.curve->off.de2000 * 1.2 + 1e-4);  // what the surface says of it
  return worst;
}

Scene film_scene(const Material& material, const char* model) {
  Scene scene;
  scene.width = scene.height = 48;
  scene.surface = film_surface(material);
  FittedModels fitted = fit_models(find_model(model), nullptr, {}, scene.surface);
  scene.specular = fitted.specular;
  scene.specular_values = std::move(fitted.specular_values);
  scene.lights = default_lights();
  scene.lights.hemispheres.reset();
  return scene;
}

}  // namespace

TEST_CASE("a stack is seen as the F0 solver sees it, at normal incidence and at cosine 1/7") {
  F0Options under_water;
  under_water.outside.index = 1.33;
  for (const F0Options& options : {F0Options{}, under_water}) {
    const Material material = film_material("anatase:120nm/titanium");
    const Stack& stack = std::get<Stack>(material.preferred_dataset().optics);
    const F0Result f0 = F0Solver(options).solve(stack);
    SeenStack seen(with_thickness(stack, 1, 40), options);
    seen.set_thickness(0, 120);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(seen(1)[c] == Approx(vec(f0.srgb_linear)[c]).epsilon(1e-12));
      CHECK(seen(1.0 / 7)[c] == Approx(vec(*f0.f82)[c]).epsilon(1e-12));
    }
  }
}

TEST_CASE("the curves of all stacks of the library are within CIEDE2000 0.1 of the exact stack") {
  int stacks = 0;
  for (const std::string& id : film_library().ids()) {
    const auto material = film_library().find(id);
    if (!std::holds_alternative<Stack>(material->preferred_dataset().optics)) continue;
    INFO(id);
    CHECK(worst_of_curve(*material) <= 0.1);
    ++stacks;
  }
  CHECK(stacks >= 16);
}

TEST_CASE("the curves of 50 random oxides on metals are within CIEDE2000 0.1") {
  std::mt19937 random(38);
  const char* const films[] = {"anatase", "tantala", "fused_silica", "sapphire", "magnesium_fluoride"};
  const char* const bases[] = {"titanium", "niobium", "copper", "silicon", "aluminum", "gold"};
  for (int i = 0; i < 50; ++i) {
    std::string text;
    for (std::uint32_t layer = 0, count = 1 + random() % 2; layer < count; ++layer)
      text += std::string(films[random() % 5]) + ":" + std::to_string(random() % 500 / count) + "nm/";
    text += bases[random() % 6];
    INFO(text);
    CHECK(worst_of_curve(film_material(text)) <= 0.1);
  }
}

TEST_CASE("fringes that are too narrow for a curve are in its error") {
  const SurfaceValues surface = film_surface(film_material("magnesium_fluoride:2um/silicon"));
  CHECK(surface.curve->off.de2000 > 1);
  CHECK(contains(curve_note(*surface.curve), "off by at most 1.4 (CIEDE2000)"));
}

TEST_CASE("a stack is drawn by its own F, whatever F the model has") {
  const SurfaceValues film = film_surface(film_material("anatase:40nm/titanium"));
  const auto drawn = [&](const char* id) { return std::string(drawn_model(find_model(id), film)->id); };
  CHECK(drawn("schueler-optimized-bounded") == "microfacet:ggx,curve,smith-ggx-height");
  CHECK(drawn("ggx-f82") == "microfacet:ggx,curve,smith-ggx-height");
  CHECK(drawn("beckmann-schlick") == "microfacet:beckmann,curve,cook-torrance");
  CHECK(drawn("ggx-exact-compensated") == "microfacet:ggx,curve,smith-ggx-compensated");
  CHECK(drawn("phong") == "phong");
  CHECK(drawn_model(nullptr, film) == nullptr);
  const auto gold = film_library().find("gold");
  CHECK(drawn_model(find_model("ggx-f82"), film_surface(*gold)) == find_model("ggx-f82"));
  // The values of the curve are those of the surface, and may be above 1 and below 0.
  SurfaceValues surface = film;
  const FittedModels fitted = fit_models(find_model("ggx-f82"), nullptr, {}, surface);
  for (std::size_t i = 0; i < 48; ++i) CHECK(fitted.specular_values[i] == film.curve->colors[i / 3][i % 3]);
}

TEST_CASE("a model with an F of its own is told to be off, by how much") {
  SurfaceValues surface = film_surface(film_material("anatase:160nm/titanium"));
  const Model& phong = *find_model("schueler-simplified");
  const FittedModels fitted = fit_models(&phong, nullptr, {}, surface);
  const std::string said = layers_remark(phong, *fitted.specular, fitted.specular_values, *surface.curve);
  CHECK(contains(said, "schueler-simplified has an F of its own"));
  CHECK(contains(said, "off by up to"));
}

TEST_CASE("the picture of a stack is that of the reference, which takes the exact stack at every angle") {
  for (const char* text : {"anatase:40nm/titanium", "anatase:160nm/titanium", "water:300nm/air"}) {
    const Material material = film_material(text);
    for (const char* model : {"schueler-optimized-bounded", "beckmann-smith"}) {
      const Scene scene = film_scene(material, model);
      const Reference reference = render_reference(scene, nullptr, {1, 0, 2});
      Image quick;
      render_cpu(scene, nullptr, 1, Precision::f64, quick);
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
          for (std::size_t c = 0; quick.at(x, y)[3] == 1 && c < 3; ++c) {
            const float truth = reference.picture.at(x, y)[c];
            REQUIRE(std::abs(quick.at(x, y)[c] - truth) <= 0.01F * std::abs(truth) + 0.0015F);
          }
    }
  }
}

TEST_CASE(
    "a clear base lets pass what passes two surfaces with their layers, by the printed formula of one film") {
  const Material material = film_material("magnesium_fluoride:100nm/fused_silica");
  const SurfaceValues surface = film_surface(material);
  REQUIRE(surface.layers);
  REQUIRE(surface.passing);
  CHECK(surface.layers->n == Approx(1.4585).margin(2e-4));
  const auto bare = film_library().find("fused_silica");
  CHECK(*surface.passing == *film_surface(*bare).passing);
  CHECK_FALSE(film_surface(*bare).layers);
  // R of one film at normal incidence: (r^2 + s^2 + 2 r s cos 2 b) / (1 + r^2 s^2 + 2 r s cos 2 b); neither absorbs.
  const Stack& stack = std::get<Stack>(material.preferred_dataset().optics);
  const SeenStack seen(stack);
  Spectrum twice;
  const FilmSpectra::Medium film = seen.spectra().layers[0].medium, base = seen.spectra().base;
  for (std::size_t i = 0; i < grid_size; ++i) {
    const double nm = grid_first_nm + double(i), r = (1 - film.n[i]) / (1 + film.n[i]),
                 s = (film.n[i] - base.n[i]) / (film.n[i] + base.n[i]),
                 turn = 2 * r * s * std::cos(4 * 3.14159265358979 * film.n[i] * 100 / nm);
    const double passes = 1 - (r * r + s * s + turn) / (1 + r * r * s * s + turn);
    twice.wavelength_nm.push_back(nm);
    twice.value.push_back(passes * passes);
  }
  const LinearRgb expected = F0Solver({}).solve(Reflectance{twice}).linear;
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(seen.passed_twice(1)[c] == Approx(vec(expected)[c]).margin(1e-5));
    CHECK(surface.layers->twice.at(1)[c] == Approx(vec(expected)[c]).margin(2e-3));
    CHECK(surface.layers->twice.at(0.2)[c] == Approx(seen.passed_twice(0.2)[c]).margin(5e-3));
  }
  // The coat takes a third of what bare glass reflects away, and the light is not lost.
  CHECK(unseen_luminance(surface) < 0.7 * unseen_luminance(film_surface(*bare)));
  // A film of metal lets pass less than it does not reflect.
  const SurfaceValues gold = film_surface(film_material("gold:30nm/fused_silica"));
  REQUIRE(gold.layers);
  CHECK(unseen_luminance(gold) > luminance_of(gold.f0) + 0.1);
  CHECK_FALSE(film_surface(film_material("anatase:40nm/titanium")).layers);
}

TEST_CASE("a film of nothing on glass is drawn as bare glass is, in an environment and before a background") {
  const Environment around(environment_picture(*find_studio("studio"), 128), 1, "studio", 1);
  const Scene layered = [&] {
    Scene out = film_scene(film_material("air:0nm/fused_silica"), "beckmann-smith");
    out.surface.opacity = 0;
    out.background = {0.5, 0.5, 0.5};
    return out;
  }();
  const Scene bare = [&] {
    Scene out = film_scene(*film_library().find("fused_silica"), "beckmann-smith");
    out.surface.opacity = 0;
    out.background = layered.background;
    out.specular = layered.specular;
    out.specular_values = layered.specular_values;
    return out;
  }();
  for (const Environment* environment : {&around, static_cast<const Environment*>(nullptr)}) {
    Image with, without;
    render_cpu(layered, environment, 1, Precision::f64, with);
    render_cpu(bare, environment, 1, Precision::f64, without);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        // At the rim the index of bare glass, which is solved from F0, bends a little less.
        for (std::size_t c = 0; c < 3 && std::hypot(x - 23.5, y - 23.5) < 17; ++c)
          REQUIRE(std::abs(with.at(x, y)[c] - without.at(x, y)[c]) <= 0.02F * without.at(x, y)[c] + 0.005F);
    const Reference truth = render_reference(layered, environment, {1, 0, 2}),
                    plain = render_reference(bare, environment, {1, 0, 2});
    for (int x = 10; x < 38; ++x)
      CHECK(truth.picture.at(x, 24)[1] == Approx(plain.picture.at(x, 24)[1]).epsilon(0.02));
  }
}

TEST_CASE("a bare metal has a curve too, for who asks for that term") {
  const auto gold = film_library().find("gold");
  const SurfaceValues surface = film_surface(*gold);
  CHECK_FALSE(surface.curve);
  const FresnelCurve curve = curve_of(surface);
  const SeenStack exact(*surface.optics);
  CHECK(curve.off.de2000 < 0.01);
  for (std::size_t c = 0; c < 3; ++c) CHECK(curve.at(1)[c] == Approx(exact(1)[c]).margin(1e-4));
}
