// SPDX-License-Identifier: Apache-2.0
#include "core/certainty/thickness.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "core/base/text/text.h"
#include "core/color/delta_e.h"
#include "core/material/seen_stack.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Stack stack_of_text(const std::string& text) {
  return std::get<Stack>(material(text).preferred_dataset().optics);
}

bool holds(const FittedThickness& fit, double thickness_nm) {
  return fit.interval_nm[0] <= thickness_nm && thickness_nm <= fit.interval_nm[1];
}

constexpr std::array films{"polystyrene", "fused_silica", "tantala", "titania_amorphous",
                           "magnesium_fluoride"};
constexpr std::array bases{"silicon", "titanium", "aluminum", "gold"};

}  // namespace

TEST_CASE("the thickness of a film is found from a noisy spectrum, and its interval is honest") {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> thickness(30, 600);
  std::normal_distribution<double> noise(0, 0.005);
  std::size_t near = 0, inside = 0, told = 0;
  constexpr std::size_t count = 200;
  for (std::size_t i = 0; i < count; ++i) {
    const double true_nm = thickness(random);
    const std::string text = std::string(films[i % films.size()]) + ":" + fixed(true_nm, 3) + "nm/" +
                             bases[i / films.size() % bases.size()];
    const Stack stack = stack_of_text(text);
    SeenStack seen(stack);
    const FilmSpectra& film = seen.spectra();
    std::vector<double> reflectance(film.wavelength_nm.size());
    film_reflectance(film, 1, reflectance);
    Spectrum measured;
    for (std::size_t j = 20; j < reflectance.size(); j += 5) {
      measured.wavelength_nm.push_back(film.wavelength_nm[j]);
      measured.value.push_back(reflectance[j] + noise(random));
    }
    const SpectrumFit fit = thickness_of_spectrum(stack, 0, measured);
    INFO(text);
    // Every order that fits is told, so that the true one is among them.
    const double off = std::abs(fit.best.thickness_nm - true_nm);
    near += off <= std::max(1.0, 0.01 * true_nm) ? 1 : 0;
    inside += holds(fit.best, true_nm) ? 1 : 0;
    told +=
        off <= std::max(1.0, 0.01 * true_nm) ||
                std::any_of(fit.others.begin(), fit.others.end(),
                            [&](const FittedThickness& other) {
                              return std::abs(other.thickness_nm - true_nm) <= std::max(1.0, 0.01 * true_nm);
                            })
            ? 1
            : 0;
    CHECK(fit.best.misfit == Approx(0.005).epsilon(0.5));
  }
  INFO(near << " of 200 within 1 nm or 1 %, " << inside
            << " true thicknesses inside of the interval at 90 %");
  CHECK(told >= 198);
  CHECK(near >= 190);
  CHECK(inside >= 170);
  CHECK(inside <= 194);
}

TEST_CASE("the thickness of a planted colour is among those that are told") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> thickness(5, 400), shift(-0.012, 0.012);
  std::size_t found = 0;
  constexpr std::size_t count = 500;
  for (std::size_t i = 0; i < count; ++i) {
    const double true_nm = thickness(random);
    const Stack stack = stack_of_text(std::string(films[i % films.size()]) + ":" + fixed(true_nm, 3) + "nm/" +
                                      bases[i / films.size() % bases.size()]);
    const LinearRgb exact = to_rgb(SeenStack(stack)(1));
    LinearRgb seen = exact;
    do {
      seen = {exact.r * (1 + shift(random)), exact.g * (1 + shift(random)), exact.b * (1 + shift(random))};
    } while (delta_e2000(to_lab(exact), to_lab(seen)) > 1);
    const auto answers = thickness_of_colour(stack, 0, seen, 1);
    found += std::any_of(answers.begin(), answers.end(),
                         [&](const FittedThickness& fit) { return holds(fit, true_nm); })
                 ? 1
                 : 0;
  }
  INFO(found << " of 500 true thicknesses are told");
  CHECK(found >= 485);
}

TEST_CASE("a colour that no thickness gives has no answer, a short spectrum is refused") {
  CHECK(thickness_of_colour(stack_of_text("fused_silica:0nm/silicon"), 0, {0.9, 0.05, 0.05}, 1).empty());
  const Spectrum few{{400, 500, 600}, {0.3, 0.3, 0.3}};
  CHECK(contains(
      error_of([&] { (void)thickness_of_spectrum(stack_of_text("fused_silica:0nm/silicon"), 0, few); }),
      "at least 10"));
}
