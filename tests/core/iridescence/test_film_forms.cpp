// SPDX-License-Identifier: Apache-2.0
// The forms that renderers have for films: compared with tests/data/film_forms.csv, which the published shader texts gave,
// compiled as C++ in double: the glTF Sample Viewer 1.1.0 (npm @khronosgroup/gltf-viewer), MaterialX 1.39.5, and Adobe's
// openpbr-bsdf of 2026-08-04 (a29da969; openpbr_reflection_coefficient() at 620, 540 and 450 nm). Inputs for which MaterialX gives no number are not among them: an F82 that dips below 0 inside the film, whose root it takes.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/iridescence/form.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

double value_of(const std::string& text) {
  double out = 0;
  REQUIRE(parse_number(text, out));
  return out;
}

double farthest(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

TEST_CASE(
    "every form of a film is the formula that its renderer has published, at 1,000 random inputs each") {
  const auto rows = read_csv(source_folder() + "/tests/data/film_forms.csv");
  std::map<std::string, int> seen;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const FilmForm* form = film_form(row[0]);
    REQUIRE(form != nullptr);
    FilmNumbers numbers{};
    for (std::size_t n = 0; n < form->numbers.size(); ++n) numbers[n] = value_of(row[2 + n]);
    const Vec3 published{value_of(row[11]), value_of(row[12]), value_of(row[13])};
    const Vec3 ours = form->seen(numbers, value_of(row[1]));
    INFO(row[0] << " in line " << i + 1);
    REQUIRE(farthest(ours, published) < 2e-6);  // the six digits of the file
    ++seen[row[0]];
  }
  CHECK(seen == std::map<std::string, int>{{"conductor_bsdf", 1000},
                                           {"generalized_schlick_bsdf", 1000},
                                           {"gltf", 1000},
                                           {"openpbr-adobe-dielectric", 1000},
                                           {"openpbr-adobe-metal", 1000},
                                           {"openpbr-dielectric", 1000},
                                           {"openpbr-metal", 1000}});
}

TEST_CASE("a film of no thickness leaves MaterialX's bases as they are bare") {
  const FilmNumbers metal{0.9, 0.7, 0.3, 0.9, 0.8, 0.95, 2, 0, 1};
  const FilmNumbers index{0.2, 0.9, 1.4, 3.4, 2.4, 1.8, 2, 0};
  for (const double cosine : {1.0, 0.7, 0.2, 0.05})
    for (std::size_t c = 0; c < 3; ++c) {
      const double bare = f64::f_f82_tint(metal[c], metal[c + 3], cosine);
      CHECK(film_form("generalized_schlick_bsdf")->seen(metal, cosine)[c] == bare);
      CHECK(film_form("openpbr-metal")->seen(metal, cosine)[c] == Approx(bare).epsilon(1e-15));
      CHECK(film_form("conductor_bsdf")->seen(index, cosine)[c] ==
            f64::fresnel_exact(index[c], index[c + 3], cosine));
    }
}

// Gulbrandsen's edge tint 1 is the least n that he allows, (1 - r) / (1 + r), not the edge of F82's tint 1.
TEST_CASE("Adobe's film of the index of air takes F82's tint for the edge tint of Gulbrandsen") {
  const double r = 0.9, n = (1 - r) / (1 + r),
               k = std::sqrt((r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r));
  const FilmNumbers metal{r, r, r, 1, 1, 1, 1, 40, 1};
  for (const double cosine : {1.0, f82_cosine})
    CHECK(film_form("openpbr-adobe-metal")->seen(metal, cosine)[0] ==
          Approx(f64::fresnel_exact(n, k, cosine)).epsilon(1e-12));
  CHECK(f64::fresnel_exact(n, k, f82_cosine) > f64::f_f82_tint(r, 1, f82_cosine) + 0.01);
}

// MaterialX gives each polarisation half of the base's reflectance and takes the mean of both.
TEST_CASE("MaterialX's film of the index of air halves a Schlick metal, and leaves a conductor as it is") {
  const FilmNumbers metal{0.9, 0.9, 0.9, 1, 1, 1, 1, 0.001};
  const Vec3 film = film_form("generalized_schlick_bsdf")->seen(metal, 1);
  for (const double channel : film) CHECK(channel == Approx(0.45).margin(1e-3));
  const FilmNumbers index{1, 1, 1, 6, 6, 6, 1, 0.001};
  const Vec3 conductor = film_form("conductor_bsdf")->seen(index, 1);
  for (const double channel : conductor) CHECK(channel == Approx(f64::f0(1, 6)).margin(1e-3));
}

TEST_CASE("forms take the numbers that they name, in ranges that are not empty") {
  for (const FilmForm* form : film_forms()) {
    INFO(form->id);
    CHECK(form->numbers.size() <= most_film_numbers);
    CHECK(film_form(form->id) == form);
    for (const FilmNumber& number : form->numbers) CHECK(number.least < number.most);
    if (form->index < form->numbers.size()) {
      CHECK(form->numbers[form->index].least >= 1);
      CHECK(form->numbers[form->index + 1].least > 0.03);  // below it glTF turns the index into that of air
    }
  }
  CHECK(film_form("nothing") == nullptr);
}
