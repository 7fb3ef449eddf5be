// SPDX-License-Identifier: Apache-2.0
// A clear layer over a material: what the base reflects under it, and what is seen of both.
#include "core/material/f0_coat.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/color/delta_e.h"
#include "core/material/f0/f0_settings.h"
#include "core/material/f0/f0_steps.h"
#include "core/material/find.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

using Complex = std::complex<double>;

const LibraryWhenAsked names_of_coats = []() -> const MaterialLibrary& { return library(); };

Optics optics_below(const std::string& text) {
  return find_material(library(), text)->answer.material.preferred_dataset().optics;
}

CoatedF0 coated_with(const std::string& coat, const Optics& optics, const F0Options& options = {}) {
  CoatedF0 out;
  REQUIRE(coated(coat_setting(coat, names_of_coats), options, optics, "", out) == "");
  return out;
}

Optics flat_medium(double n, double k) {
  return OpticalConstants{Spectrum{{550}, {n}}, Spectrum{{550}, {k}}};
}

// Fresnel's equations as they are printed, s and p, between media of these indices.
std::array<double, 2> printed_fresnel(Complex from, Complex to, double sine) {
  const Complex a = std::sqrt(1.0 - sine * sine / (from * from)),
                b = std::sqrt(1.0 - sine * sine / (to * to));
  return {std::norm((from * a - to * b) / (from * a + to * b)),
          std::norm((to * a - from * b) / (to * a + from * b))};
}

void check_grey(const LinearRgb& color, double expected) {
  INFO(expected);
  CHECK(color.r == Approx(expected).epsilon(1e-11));
  CHECK(color.g == Approx(expected).epsilon(1e-11));
  CHECK(color.b == Approx(expected).epsilon(1e-11));
}

}  // namespace

TEST_CASE("a coat of one index over one n and k has the closed form of both, s and p by themselves") {
  const double outside = 1.1, n = 1.6, cosine = 1.0 / 7;
  const Complex base{0.9, 3.2};
  F0Options options;
  options.outside = {"1.1", outside};
  const CoatedF0 found = coated_with("1.6", flat_medium(base.real(), base.imag()), options);
  CHECK(found.n == n);
  const double under = std::norm((base - n) / (base + n)), s = std::norm((n - outside) / (n + outside));
  check_grey(found.under.linear, under);
  const double inside = n * std::sqrt(1 - cosine * cosine);
  const auto edge = printed_fresnel(n, base, inside);
  check_grey(*found.under.f82, (edge[0] + edge[1]) / 2);
  check_grey(found.energy_left.linear, (1 - s) * (1 - s) / (1 - s * under));
  check_grey(found.whole.linear, s + (1 - s) * (1 - s) * under / (1 - s * under));
  const double sine = outside * std::sqrt(1 - cosine * cosine);
  const auto upper = printed_fresnel(outside, n, sine), lower = printed_fresnel(n, base, sine);
  double whole = 0;
  for (int i = 0; i < 2; ++i)
    whole += (upper[i] + (1 - upper[i]) * (1 - upper[i]) * lower[i] / (1 - upper[i] * lower[i])) / 2;
  check_grey(*found.whole.f82, whole);
}

TEST_CASE("a coat that absorbs takes its share on the way down and up again") {
  Coat coat{"tinted", {Spectrum{{550}, {1.5}}, Spectrum{{550}, {2e-9}}}, 1.5, 3e7};
  CoatedF0 found;
  REQUIRE(coated(coat, {}, flat_medium(0.2, 3.4), "", found) == "");
  // Each wavelength by itself, with the sums of intensities written out, and integrated as a table of reflectance.
  const double s = 0.04, under = std::norm((Complex(0.2, 3.4) - 1.5) / (Complex(0.2, 3.4) + 1.5));
  Spectrum left, whole;
  for (int nm = grid_first_nm; nm <= grid_last_nm; ++nm) {
    const double once = std::exp(-4 * std::numbers::pi * 2e-9 * 3e7 / nm);
    double sum = 0;  // of what gets out after 1, 2, ... reflections at the base
    double inside = (1 - s) * once;
    for (int turn = 0; turn < 60; ++turn) {
      inside *= under * once;
      sum += inside * (1 - s);
      inside *= s * once;
    }
    left.wavelength_nm.push_back(nm);
    whole.wavelength_nm.push_back(nm);
    left.value.push_back(sum / under);
    whole.value.push_back(s + sum);
  }
  const F0Solver solver({});
  const LinearRgb expected = solver.solve(Reflectance{whole}).linear;
  CHECK(found.whole.linear.r == Approx(expected.r).epsilon(1e-8));
  CHECK(found.whole.linear.b == Approx(expected.b).epsilon(1e-8));
  const LinearRgb share = solver.solve(Reflectance{left}).linear;
  CHECK(found.energy_left.linear.r == Approx(share.r).epsilon(1e-8));
  CHECK(found.energy_left.linear.b == Approx(share.b).epsilon(1e-8));
  CHECK(found.energy_left.linear.b < found.energy_left.linear.r);  // blue is absorbed more by the same k
}

TEST_CASE("a coat of the index outside changes nothing, and one of the base's own index leaves its surface") {
  for (const std::string id : {"gold", "silicon", "fused_silica", "anatase:40nm/titanium"}) {
    INFO(id);
    const Optics optics = optics_below(id);
    const F0Result bare = F0Solver({}).solve(optics);
    const CoatedF0 same = coated_with("1", optics);
    for (const F0Result* part : {&same.under, &same.whole}) {
      CHECK(part->linear.r == Approx(bare.linear.r).epsilon(1e-12));
      CHECK(part->linear.b == Approx(bare.linear.b).epsilon(1e-12));
      CHECK(part->f82->g == Approx(bare.f82->g).epsilon(1e-12));
    }
    CHECK(same.energy_left.linear.r == Approx(1).epsilon(1e-12));
  }
  const CoatedF0 glass = coated_with("fused_silica", optics_below("fused_silica"));
  CHECK(glass.under.linear.g == Approx(0).margin(1e-15));
  CHECK(glass.whole.linear.g ==
        Approx(F0Solver({}).solve(optics_below("fused_silica")).linear.g).epsilon(1e-8));
}

TEST_CASE("a coat is the incoherent layer of a stack, and what lies under it is the base in that medium") {
  const Optics optics = optics_below("copper");
  const CoatedF0 found = coated_with("water/hale:2mm", optics);
  const F0Result stack = F0Solver({}).solve(optics_below("water/hale:2mm/copper"));
  CHECK(found.whole.linear.r == Approx(stack.linear.r).epsilon(1e-12));
  CHECK(found.whole.f82->b == Approx(stack.f82->b).epsilon(1e-12));
  F0Options wet;
  wet.outside = outside_medium(library(), "water/hale", "place", {});
  const F0Result under = F0Solver(wet).solve(optics);
  CHECK(found.under.linear.g == Approx(under.linear.g).epsilon(1e-12));
  CHECK(found.under.f82->g == Approx(under.f82->g).epsilon(1e-12));
  CHECK(found.n == Approx(1.333).margin(1e-3));
  // A thickness counts: metres of water are blue, by the k of another dataset where the preferred one has none.
  const CoatedF0 deep = coated_with("water:5000mm", optics);
  CHECK(deep.energy_left.linear.r < 0.2 * deep.energy_left.linear.b);
  CHECK(deep.under.linear.r == Approx(found.under.linear.r).epsilon(1e-3));
}

TEST_CASE("coats that are none are refused with one line each") {
  const auto refused = [](const std::string& text) {
    const std::string found = error_of([&] { (void)coat_setting(text, names_of_coats); });
    CHECK(found.find('\n') == found.npos);
    return found;
  };
  CHECK(contains(refused("copper"),
                 "is not clear (a conductor is not seen through); expected an index above 0"));
  CHECK(contains(refused("0"), "coat: 0; expected an index above 0 or a clear material"));
  CHECK(contains(refused("-1.5"), "-1.5; expected an index above 0"));
  CHECK(contains(refused("1.5:2mm"), "expected no thickness: an index alone absorbs nothing"));
  CHECK(contains(refused("pmma:2"), "thickness 2 has no unit"));
  CHECK(contains(refused("pmma:-2mm"), "thickness -2mm; expected a finite one"));
  CHECK(contains(refused("pmma:?mm"), "pmma:?mm; expected an index above 0 or a clear material"));
  CHECK(contains(refused("pmma:1mm:coherent"), "expected an index above 0"));
  CHECK(contains(refused("water:1mm/pmma:1mm"), "expected an index above 0"));
  CHECK(contains(refused("water:1mm/pmma"), "expected an index above 0"));
  CHECK(contains(refused("lacquor"), "no material of the library is called lacquor; expected an index"));
  CHECK(contains(refused("spectralon"), "is not clear"));
  F0Options exact;
  exact.method = Method::exact;
  CHECK(contains(error_of([&] { (void)coat_option("1.5", names_of_coats, exact, false); }),
                 "exact beside a coat; expected 1nm or another sum"));
  F0Options cone;
  cone.instrument.aperture = 0.5;
  CHECK(contains(error_of([&] { (void)coat_option("1.5", names_of_coats, cone, false); }),
                 "expected one of them"));
}

TEST_CASE(
    "reflectance at normal incidence alone is refused under a coat, because media of one F0 differ there") {
  // Two media of F0 0.4, one of which reflects more under a coat of 1.5 and one less.
  const double root = std::sqrt(0.4), n = (1 + root) / (1 - root);
  const auto under = [](Complex index) { return std::norm((index - 1.5) / (index + 1.5)); };
  CHECK(std::norm((n - 1) / (n + 1)) == Approx(0.4));
  CHECK(std::norm((1 / n - 1) / (1 / n + 1)) == Approx(0.4));
  CHECK(under(n) < 0.25);
  CHECK(under(1 / n) > 0.54);
  CoatedF0 out;
  CHECK(contains(
      error_of([&] {
        coated(coat_setting("1.5", names_of_coats), {}, optics_below("spectralon"), "spectralon", out);
      }),
      "spectralon: reflectance at normal incidence tells nothing of what is reflected under a coat; "
      "expected data of n and k"));
}
