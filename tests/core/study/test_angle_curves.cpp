// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/base/number.h"
#include "core/brdf/models.h"
#include "core/material/library.h"
#include "core/plot/lobe_curves.h"
#include "core/study/angle_curves.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

AngleCurves of_library(const char* id, const F0Options& options = {}) {
  const Material material = *MaterialLibrary::builtin().find(id);
  return angle_curves(material.preferred_dataset().optics, options, id);
}

const AngleCurve& form(const AngleCurves& curves, std::string_view id) {
  for (const AngleCurve& each : curves.forms)
    if (each.id == id) return each;
  FAIL("no form " << id);
  return curves.forms.front();
}

}  // namespace

TEST_CASE("errors of flat data are those of Fresnel's equations in complex numbers") {
  // Printed: silicon 0.206 and 0.042, glass 0.036 and 0.028.
  struct Row {
    double n, k, schlick, f82;
  };
  for (const Row& row : {Row{4.08, 0.03, 0.206, 0.042}, Row{1.5, 0, 0.036, 0.028}, Row{0.96, 6.69, 0, 0}}) {
    const auto optics = constants(
        wavelengths(300, 900, 100), [&](double) { return row.n; }, [&](double) { return row.k; });
    const AngleCurves curves = angle_curves(optics, {}, "flat");
    const std::complex<double> m(row.n, row.k);
    const auto exact = [&](double c) {
      const auto ct = std::sqrt(1.0 - (1 - c * c) / (m * m));
      return (std::norm((c - m * ct) / (c + m * ct)) + std::norm((m * c - ct) / (m * c + ct))) / 2;
    };
    const double f0 = exact(1), f82 = exact(1.0 / 7);
    const double bend = (f0 + (1 - f0) * std::pow(6.0 / 7, 5) - f82) * 17.6513846;
    double schlick = 0, bent = 0;
    for (const double angle : curves.angle_deg) {
      const double c = std::cos(angle * std::numbers::pi / 180), s = f0 + (1 - f0) * std::pow(1 - c, 5);
      schlick = std::max(schlick, std::abs(s - exact(c)));
      bent = std::max(bent, std::abs(s - bend * c * std::pow(1 - c, 6) - exact(c)));
    }
    CHECK(form(curves, "schlick").error.max_abs == Approx(schlick).margin(1e-7));
    CHECK(form(curves, "f82").error.max_abs == Approx(bent).margin(1e-7));
    if (row.schlick > 0) {
      CHECK(schlick == Approx(row.schlick).margin(0.0015));
      CHECK(bent == Approx(row.f82).margin(0.0015));
    }
  }
}

TEST_CASE("F82 is several times nearer to the exact curve of a metal than Schlick") {
  for (const char* id : {"chromium", "silicon", "aluminum", "titanium", "iron"}) {
    INFO(id);
    const AngleCurves curves = of_library(id);
    CHECK(form(curves, "schlick").error.max_abs > 0.05);
    CHECK(form(curves, "f82").error.max_abs < form(curves, "schlick").error.max_abs / 3);
  }
}

TEST_CASE("the exact curve begins at F0 and ends at 1, and the forms pass through F0 and F82") {
  for (const char* id : {"gold", "fused_silica", "silicon"}) {
    const Material material = *MaterialLibrary::builtin().find(id);
    const AngleCurves curves = of_library(id);
    const F0Result f0 = F0Solver(F0Options{}).solve(material.preferred_dataset().optics);
    REQUIRE(curves.exact.size() == curves.angle_deg.size());
    CHECK(curves.angle_deg.front() == 0);
    CHECK(curves.angle_deg.back() == Approx(90).epsilon(1e-12));
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(curves.exact.front()[c] == Approx(vec(f0.srgb_linear)[c]).margin(1e-9));
      CHECK(curves.exact.back()[c] == Approx(1).epsilon(1e-9));
      CHECK(form(curves, "schlick").rgb.front()[c] == Approx(vec(f0.srgb_linear)[c]).margin(1e-9));
    }
    // The stated error is that of the points shown.
    for (const AngleCurve& each : curves.forms) {
      double most = 0;
      for (std::size_t i = 0; i < each.rgb.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
          most = std::max(most, std::abs(each.rgb[i][c] - curves.exact[i][c]));
      CHECK(each.error.max_abs == Approx(most).epsilon(1e-9));
    }
  }
}

TEST_CASE("the outside medium, the illuminant and the observer count") {
  F0Options options;
  options.outside = {"1.33", 1.33};
  options.viewing.illuminant = Illuminant::a;
  options.viewing.observer = Observer::cie1964_10deg;
  const Material gold = *MaterialLibrary::builtin().find("gold");
  const F0Result f0 = F0Solver(options).solve(gold.preferred_dataset().optics);
  const AngleCurves curves = of_library("gold", options);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(curves.exact.front()[c] == Approx(vec(f0.srgb_linear)[c]).margin(1e-9));
}

TEST_CASE("reflectance data have no exact curve and no errors") {
  const auto optics = reflectance(wavelengths(360, 830, 10), [](double) { return 0.5; });
  const AngleCurves curves = angle_curves(optics, {}, "flat");
  CHECK(curves.exact.empty());
  REQUIRE(curves.forms.size() == 2);
  CHECK(curves.forms[0].rgb.front()[1] == Approx(0.5));
  CHECK(curves.forms[0].error.max_abs == 0);
}

TEST_CASE("times are measured and Schlick takes less than 471 wavelengths") {
  AngleCurves curves = of_library("gold");
  CHECK(curves.forms[0].ns == 0);
  time_angle_curves(curves);
  for (const AngleCurve& each : curves.forms) {
    INFO(each.id);
    CHECK(each.ns > 0);
    CHECK(each.ns < 1e5);
  }
  CHECK(curves.exact_ns > form(curves, "schlick").ns);
}

TEST_CASE("a lobe has its mirror direction and is finite at the horizon") {
  const Model& model = *find_model("ggx-schlick");
  std::vector<double> values;
  for (const Parameter& p : model.parameters) values.insert(values.end(), p.color ? 3 : 1, p.initial);
  const LobeCurve lobe = lobe_curve(model, values, 33.3);
  CHECK(lobe.light_deg == -33.3);
  CHECK(std::is_sorted(lobe.angle_deg.begin(), lobe.angle_deg.end()));
  const auto mirror = std::find(lobe.angle_deg.begin(), lobe.angle_deg.end(), 33.3);
  REQUIRE(mirror != lobe.angle_deg.end());
  double most = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < lobe.rgb.size(); ++i)
    if (lobe.rgb[i][0] > most) most = lobe.rgb[i][0], at = i;
  // Near the mirror direction, a little beyond where F and V rise.
  CHECK(std::abs(lobe.angle_deg[at] - 33.3) < 3);
  for (const Vec3& rgb : lobe.rgb) CHECK(std::isfinite(rgb[0]));
  // Two neighbouring angles never stand on one another.
  CHECK(std::adjacent_find(lobe.angle_deg.begin(), lobe.angle_deg.end()) == lobe.angle_deg.end());
}

TEST_CASE("F at one angle is that of the whole truth, in any medium and light") {
  const Material copper = *MaterialLibrary::builtin().find("copper");
  const auto& optics = std::get<OpticalConstants>(copper.preferred_dataset().optics);
  F0Options options;
  options.viewing.illuminant = Illuminant::a;
  options.outside.index = 1.33;
  const SeenStack seen(optics, options);
  const FresnelTruth truth = fresnel_truth(optics, "copper", 30, options);
  REQUIRE(truth.cosine.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(seen(truth.cosine[i]) == truth.rgb[i]);
  CHECK(seen(1) == truth.f0);
}

TEST_CASE("what etak models claims of Schlick on metals is his largest error over the library's metals") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  double worst = 0;
  std::string of;
  for (const std::string& id : library.ids()) {
    const Material material = *library.find(id);
    const Optics& optics = material.preferred_dataset().optics;
    if (material.material_class != "metal" || std::holds_alternative<Stack>(optics)) continue;
    const AngleCurves curves = angle_curves(optics, {}, id);
    if (curves.exact.empty() || form(curves, "schlick").error.max_abs <= worst) continue;
    worst = form(curves, "schlick").error.max_abs;
    of = id;
  }
  INFO(of << ' ' << worst);
  CHECK(of == "osmium");
  const Term& schlick = *find_term(TermKind::fresnel, "schlick");
  CHECK(std::string(schlick.note) == "metals off by up to " + number(std::ceil(worst * 100) / 100, 2));
}
