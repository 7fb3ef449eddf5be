// SPDX-License-Identifier: Apache-2.0
// Layers on a base: compared with tests/data/stacks.csv (60 digits), with closed forms and with themselves.
#include "core/film/stack.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/math/functions.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// The formula text in single precision, as a GPU runs it.
namespace single {
#include "core/math/real_f32.h"

#include "core/film/texts.h"
}  // namespace single

double value_of(const std::string& text) {
  double out = 0;
  REQUIRE(parse_number(text, out));
  return out;
}

struct Case {
  std::string kind;
  Film film;
  double wavelength, cosine, s, p;
  std::optional<double> passed;
};

std::vector<std::string> parts_of(const std::string& text, char between) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, between);) out.push_back(part);
  return out;
}

std::vector<Case> cases() {
  std::vector<Case> out;
  const auto rows = read_csv(source_folder() + "/tests/data/stacks.csv");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    Case one{row[0],
             {value_of(row[1]), {}, {value_of(row[3]), value_of(row[4])}},
             value_of(row[5]),
             value_of(row[6]),
             value_of(row[7]),
             value_of(row[8]),
             {}};
    for (const std::string& layer : parts_of(row[2], ' ')) {
      const auto numbers = parts_of(layer, ':');
      one.film.layers.push_back({{value_of(numbers[0]), value_of(numbers[1])}, value_of(numbers[2]), true});
    }
    if (!row[9].empty()) one.passed = value_of(row[9]);
    out.push_back(std::move(one));
  }
  return out;
}

// The phases of a film: the sum of 2 pi |N| d / wavelength.
double phases(const Case& one) {
  double sum = 0;
  for (const FilmLayer& layer : one.film.layers)
    sum += 2 * std::numbers::pi * std::hypot(layer.medium.n, layer.medium.k) * layer.thickness_nm /
           one.wavelength;
  return sum;
}

double most_error(const Case& one, double expected) {
  if (one.kind == "thick") return 1e-15 * (1 + phases(one));
  const double relative = one.kind == "grazing" ? 1e-9 : one.kind == "critical" ? 1e-7 : 1e-11;
  return expected >= 1e-4 ? relative * expected : 1e-15;
}

void near(double value, double expected, double most) {
  CHECK(std::abs(value - expected) <= most);
}

class RandomMedia {
 public:
  double operator()(double from, double to) { return std::uniform_real_distribution(from, to)(engine_); }
  FilmMedium clear() { return {(*this)(1, 3), 0}; }
  FilmMedium any() { return {(*this)(0.1, 3), (*this)(0, 1) < 0.5 ? 0 : (*this)(0, 5)}; }

 private:
  std::mt19937 engine_{38};
};

}  // namespace

TEST_CASE("reflectances and transmittances of films are those of 60 digits") {
  const auto all = cases();
  CHECK(all.size() >= 300);
  for (const Case& one : all) {
    INFO(one.kind << ", " << one.film.layers.size() << " layers, cosine " << number(one.cosine, 17));
    const FilmLight light = film_light(one.film, one.wavelength, one.cosine);
    near(light.reflected.s, one.s, most_error(one, one.s));
    near(light.reflected.p, one.p, most_error(one, one.p));
    near(light.reflected.mean(), (one.s + one.p) / 2, most_error(one, (one.s + one.p) / 2));
    // Near grazing and near a critical angle nearly nothing passes, and the last digit of the cosine says how little.
    if (one.passed) near(light.passed.mean(), *one.passed, std::max(1e-14, 10 * most_error(one, 1)));
  }
}

// What two other programs give: tmm 0.2.0 (S. J. Byrnes), for the inputs of its own tests and examples and for two panes, and
// colour-science 0.4.7, the one value that its documentation prints. Numbers alone; no code of them.
TEST_CASE("films are those of two independent programs, to the digits that they print") {
  const auto rows = read_csv(source_folder() + "/tests/data/films_of_others.csv");
  REQUIRE(rows.size() == 11);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    INFO(row[0] << ' ' << row[2]);
    Film film{value_of(row[3]), {}, {value_of(row[5]), value_of(row[6])}};
    for (const std::string& layer : parts_of(row[4], ' ')) {
      const auto parts = parts_of(layer, ':');
      film.layers.push_back(
          {{value_of(parts[0]), value_of(parts[1])}, value_of(parts[2]), parts.size() == 3});
    }
    const FilmLight light = film_light(film, value_of(row[7]), value_of(row[8]));
    const double most = row[0] == "tmm" ? 1e-13 : 1e-7;
    near(light.reflected.s, value_of(row[9]), most);
    near(light.reflected.p, value_of(row[10]), most);
  }
}

TEST_CASE("in single precision films of a micrometre in all are within 1e-4") {
  std::size_t compared = 0;
  double most = 0;
  for (const Case& one : cases()) {
    double thickness = 0;
    for (const FilmLayer& layer : one.film.layers) thickness += layer.thickness_nm;
    // Near a critical angle the last digit of a float's cosine decides.
    if (thickness > 1000 || one.kind == "critical") continue;
    const auto f = [](double value) { return static_cast<float>(value); };
    const float n0 = f(one.film.outside), c = f(one.cosine);
    single::FilmStack stack = single::film_on(n0, c, f(one.film.base.n), f(one.film.base.k));
    for (std::size_t j = one.film.layers.size(); j-- > 0;) {
      const FilmLayer& layer = one.film.layers[j];
      const double turns = 2 * std::numbers::pi * layer.thickness_nm / one.wavelength;
      stack = single::film_over(stack, n0, c, f(layer.medium.n), f(layer.medium.k), f(turns));
    }
    INFO(one.kind << ", " << one.film.layers.size() << " layers, cosine " << number(one.cosine, 17));
    const double error = std::abs(double{single::film_mean(stack, n0, c)} - (one.s + one.p) / 2);
    CHECK(error <= 1e-4);
    most = std::max(most, error);
    ++compared;
  }
  CHECK(compared >= 90);
  CHECK(most > 1e-8);  // single precision was used
}

TEST_CASE("what a film of clear layers does not reflect it lets pass, thick panes among them") {
  RandomMedia random;
  for (int i = 0; i < 3000; ++i) {
    Film film{random(1, 1.6), {}, random.clear()};
    for (int layers = i % 9; layers > 0; --layers)
      film.layers.push_back({random.clear(), random(0, 3000), random(0, 1) < 0.7});
    const FilmLight light = film_light(film, random(360, 830), random(0.01, 1));
    near(light.reflected.s + light.passed.s, 1, 1e-12);
    near(light.reflected.p + light.passed.p, 1, 1e-12);
  }
}

TEST_CASE("no layer, layers of no thickness, of the outside medium and of the base leave the bare surface") {
  RandomMedia random;
  for (int i = 0; i < 200; ++i) {
    const FilmMedium base = random.any();
    const double cosine = random(0.01, 1), exact = f64::fresnel_exact(base.n, base.k, cosine);
    const auto reflectance = [&](std::vector<FilmLayer> layers) {
      return film_light({1, std::move(layers), base}, 550, cosine).reflected.mean();
    };
    near(reflectance({}), exact, 1e-14);
    near(reflectance({{random.any(), 0, true}}), exact, 1e-12);
    near(reflectance({{{1, 0}, random(0, 500), true}}), exact, 1e-13);
    near(reflectance({{base, random(0, 500), true}}), exact, 1e-13);
  }
}

TEST_CASE("an opaque layer hides what lies below, and two layers alike are one") {
  RandomMedia random;
  for (int i = 0; i < 200; ++i) {
    const double cosine = random(0.05, 1), first = random(0, 200), second = random(0, 200);
    const FilmMedium metal{random(0.1, 3), random(3, 8)}, medium = random.any(), base = random.any();
    const auto light = [&](std::vector<FilmLayer> layers, FilmMedium below) {
      return film_light({1, std::move(layers), below}, 550, cosine).reflected;
    };
    near(light({{metal, 5000, true}}, base).mean(), f64::fresnel_exact(metal.n, metal.k, cosine), 1e-13);
    const FilmShares two = light({{medium, first, true}, {medium, second, true}}, base);
    const FilmShares one = light({{medium, first + second, true}}, base);
    near(two.s, one.s, 1e-12);
    near(two.p, one.p, 1e-12);
  }
}

TEST_CASE("a quarter wave reflects ((n0 n - n1^2) / (n0 n + n1^2))^2, and nothing where n1^2 = n0 n") {
  const double n1 = 1.38, n = 1.52, quarter = 550 / (4 * n1);
  const double expected = std::pow((n - n1 * n1) / (n + n1 * n1), 2);
  near(film_light({1, {{{n1, 0}, quarter, true}}, {n, 0}}, 550, 1).reflected.mean(), expected, 1e-15);
  const double matched = std::sqrt(n);
  near(film_light({1, {{{matched, 0}, 550 / (4 * matched), true}}, {n, 0}}, 550, 1).reflected.mean(), 0,
       1e-30);
}

TEST_CASE("a pane reflects the sum of its two surfaces' reflections, without fringes") {
  // Both sides of glass in air: 2 R / (1 + R).
  const double r = 0.04, cosine = 1;
  const Film pane{1, {{{1.5, 0}, 2e6, false}}, {1, 0}};
  near(film_light(pane, 550, cosine).reflected.mean(), 2 * r / (1 + r), 1e-14);
  near(film_light(pane, 551, cosine).reflected.mean(), 2 * r / (1 + r), 1e-14);
  // One that absorbs: R + T^2 R A^2 / (1 - R^2 A^2), A = exp(-4 pi k d / wavelength).
  const double k = 1e-5, d = 1e5, keeps = std::exp(-4 * std::numbers::pi * k * d / 550);
  const double bare = f64::fresnel_exact(1.5, k, 1);
  const double both = bare + std::pow((1 - bare) * keeps, 2) * bare / (1 - std::pow(bare * keeps, 2));
  near(film_light({1, {{{1.5, k}, d, false}}, {1, 0}}, 550, 1).reflected.mean(), both, 1e-9);
}

TEST_CASE("a coherent film whose fringes are averaged reflects what an incoherent one does") {
  const FilmMedium base{0.2, 3.4}, varnish{1.5, 0};
  double sum = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    const double thickness = 1e5 + 550 / (2 * 1.5) * i / steps;  // a whole fringe
    sum += film_light({1, {{varnish, thickness, true}}, base}, 550, 1).reflected.mean() / steps;
  }
  near(film_light({1, {{varnish, 1e5, false}}, base}, 550, 1).reflected.mean(), sum, 1e-6);
}

TEST_CASE("grazing light is all reflected") {
  const FilmLight light = film_light({1, {{{1.4, 0}, 100, true}}, {0.2, 3}}, 550, 0);
  CHECK(light.reflected.mean() == 1);
  CHECK(light.passed.mean() == 0);
}

TEST_CASE("spectra in vector lanes have the reflectances of single wavelengths") {
  RandomMedia random;
  constexpr std::size_t count = 471;
  for (int i = 0; i < 60; ++i) {
    const double cosine = i % 3 == 0 ? 1 : random(0.001, 1);
    const auto row = [&](double from, double to) {
      std::vector<double> out(count);
      for (double& each : out) each = random(from, to);
      return out;
    };
    const auto wavelength = row(360, 830), outside = row(1, 1.5);
    std::vector<std::vector<double>> n, k;
    std::vector<double> thickness;
    const std::size_t layers = static_cast<std::size_t>(i) % 9;
    for (std::size_t j = 0; j <= layers; ++j) {
      n.push_back(row(0.1, 3));
      k.push_back(j % 2 == 0 ? row(0, 4) : row(0, 1e-3));
      thickness.push_back(random(0, 500));
    }
    FilmSpectra film{{outside, {}, {n[layers], k[layers]}}, wavelength};
    const std::size_t thick = i % 4 == 3 ? 0 : layers;  // some have a layer that is not coherent
    for (std::size_t j = 0; j < layers; ++j) film.layers.push_back({{n[j], k[j]}, thickness[j], j != thick});
    std::vector<double> out(count);
    film_reflectance(film, cosine, out);
    for (std::size_t w = 0; w < count; w += 10) {
      Film one{outside[w], {}, {n[layers][w], k[layers][w]}};
      for (std::size_t j = 0; j < layers; ++j)
        one.layers.push_back({{n[j][w], k[j][w]}, thickness[j], j != thick});
      near(out[w], film_light(one, wavelength[w], cosine).reflected.mean(), 1e-13);
    }
  }
}

TEST_CASE("media and thicknesses that cannot be are refused, with the layer's number") {
  const auto error = [](const Film& film) { return error_of([&] { validate(film, "stack"); }); };
  CHECK(error({1, {{{1.5, 0}, 100, true}}, {2, 1}}).empty());
  CHECK(contains(error({0, {}, {2, 1}}), "outside medium"));
  CHECK(contains(error({1, {{{1.5, 0}, 100, true}, {{1.5, 0}, -1, true}}, {2, 1}}),
                 "layer 2: thickness -1 nm"));
  CHECK(contains(error({1, {{{1.5, 0}, std::nan(""), true}}, {2, 1}}), "layer 1: thickness"));
  CHECK(contains(error({1, {{{1.5, -1}, 1, true}}, {2, 1}}), "k -1"));
  CHECK(contains(error({1, {{{0, 0}, 1, true}}, {2, 1}}), "n = k = 0"));
  CHECK(contains(error({1, {}, {std::nan(""), 1}}), "base"));
}
