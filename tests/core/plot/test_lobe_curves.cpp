// SPDX-License-Identifier: Apache-2.0
#include "core/plot/lobe_curves.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace etak;
using std::numbers::pi;

TEST_CASE("a curve of F runs from F0 to 1 at grazing incidence, over angles that divide 90 degrees") {
  const double f0[] = {0.04, 0.2, 1};
  const LobeCurve curve = term_curve(*find_term(TermKind::fresnel, "schlick"), f0, 45, 30);
  REQUIRE(curve.angle_deg == std::vector<double>{0, 30, 60, 90});
  CHECK(curve.rgb.front() == Vec3{0.04, 0.2, 1});
  CHECK(curve.rgb[2][0] == Approx(0.04 + 0.96 / 32));
  CHECK(curve.rgb[2][1] == Approx(0.2 + 0.8 / 32));
  for (const double each : curve.rgb.back()) CHECK(each == Approx(1).epsilon(1e-14));
}

TEST_CASE(
    "a curve of D is over the half vector, one of V over the viewer with the mirror direction among the angles") {
  const double alpha[] = {0.5};
  const LobeCurve facets = term_curve(*find_term(TermKind::distribution, "ggx"), alpha, 45, 45);
  REQUIRE(facets.angle_deg.size() == 3);
  CHECK(facets.rgb[0][0] == Approx(1 / (pi * 0.25)));
  CHECK(facets.rgb[1][0] == Approx(0.25 / (pi * std::pow(0.5 * (0.25 - 1) + 1, 2))));
  CHECK(facets.rgb[2][0] == Approx(0.25 / pi));
  const LobeCurve masking = term_curve(*find_term(TermKind::visibility, "implicit"), {}, 20, 45);
  CHECK(masking.angle_deg == std::vector<double>{-90, -45, 0, 20, 45, 90});
  CHECK(masking.light_deg == -20);
  for (const Vec3& each : masking.rgb) CHECK(each[0] == 0.25);
}
