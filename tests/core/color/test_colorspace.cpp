// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/colorspace.h"
#include "core/spectrum/integration.h"
#include "tests/core/color/whites.h"

using namespace etak;

namespace {

Xyz discrete_white(Method method, Viewing viewing) {
  return to_xyz(make_quadrature(method, viewing).white());
}

void near(const Mat3& got, const Mat3& want, double margin) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      INFO("row " << i << " column " << j);
      CHECK(got[i][j] == Approx(want[i][j]).margin(margin));
    }
}

}  // namespace

TEST_CASE("a matrix times its inverse is the identity") {
  const Mat3 m{{{3, 1, -2}, {0.5, 7, 1}, {-4, 0.25, 9}}};
  near(m * inverse(m), identity3, 1e-15);
  near(inverse(m) * m, identity3, 1e-15);
  CHECK(diagonal({2, 3, 4}) * Vec3{1, 1, 1} == Vec3{2, 3, 4});
}

TEST_CASE("matrices from primaries are those that the standards print") {
  SECTION("sRGB, IEC 61966-2-1") {
    near(inverse(rgb_to_xyz(primaries(RgbSpace::srgb), test::d65)),
         {{{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}}, 6e-4);
  }
  SECTION("the same with etak's discrete white") {
    const Xyz white = discrete_white(Method::nm1, {});
    near(xyz_to_rgb(RgbSpace::srgb, white, white),
         {{{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}}, 1e-3);
  }
  SECTION("Rec.2020, ITU-R BT.2020") {
    near(rgb_to_xyz(primaries(RgbSpace::rec2020), test::d65),
         {{{0.636958, 0.144617, 0.168881}, {0.262700, 0.677998, 0.059302}, {0, 0.028073, 1.060985}}}, 1e-6);
  }
  SECTION("Display P3") {
    near(rgb_to_xyz(primaries(RgbSpace::display_p3), test::d65),
         {{{0.486571, 0.265668, 0.198217}, {0.228975, 0.691739, 0.079287}, {0, 0.045113, 1.043944}}}, 1e-6);
  }
  SECTION("ACEScg, S-2014-004") {
    near(rgb_to_xyz(primaries(RgbSpace::acescg), test::aces_white),
         {{{0.6624541811, 0.1340042065, 0.1561876870},
           {0.2722287168, 0.6740817658, 0.0536895174},
           {-0.0055746495, 0.0040607335, 1.0103391003}}},
         1e-9);
  }
}

TEST_CASE("a primary alone has its chromaticity") {
  for (const RgbSpace space : all_rgb_spaces) {
    if (space == RgbSpace::xyz) continue;
    const Mat3 m = rgb_to_xyz(primaries(space), test::d65);
    for (std::size_t c = 0; c < 3; ++c) {
      const double sum = m[0][c] + m[1][c] + m[2][c];
      CHECK(m[0][c] / sum == Approx(primaries(space)[c][0]).epsilon(1e-13));
      CHECK(m[1][c] / sum == Approx(primaries(space)[c][1]).epsilon(1e-13));
    }
  }
}

TEST_CASE("Bradford from D65 to D50 is the published matrix") {
  // B. Lindbloom, "Chromatic Adaptation", from the ASTM E308 whites.
  near(bradford({0.95047, 1, 1.08883}, {0.96422, 1, 0.82521}),
       {{{1.0478112, 0.0228866, -0.0501270},
         {0.0295424, 0.9904844, -0.0170491},
         {-0.0092345, 0.0150436, 0.7521316}}},
       5e-5);
}

TEST_CASE("Bradford maps white onto white, there and back") {
  const Mat3 there = bradford(test::d65, test::aces_white), back = bradford(test::aces_white, test::d65);
  const Vec3 white = there * vec(test::d65);
  for (std::size_t c = 0; c < 3; ++c) CHECK(white[c] == Approx(vec(test::aces_white)[c]).epsilon(1e-14));
  near(back * there, identity3, 1e-14);
  near(bradford(test::d65, test::d65), identity3, 1e-14);
}

TEST_CASE("a flat reflectance has R = G = B to 1e-12 in every space, illuminant, observer and method") {
  for (const Method method : all_methods) {
    if (samples_rgb(method)) continue;
    for (const auto observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
      for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e}) {
        const Quadrature q = make_quadrature(method, {observer, illuminant});
        const Xyz white = to_xyz(q.white());
        const Xyz d65_white = discrete_white(method, {observer, Illuminant::d65});
        for (const RgbSpace space : all_rgb_spaces) {
          INFO(name(method) << " " << name(observer) << " " << name(illuminant) << " " << name(space));
          const Mat3 m = xyz_to_rgb(space, white, d65_white);
          for (const double r : {1.0, 0.5, 0.04, 1e-4}) {
            const Vec3 got = m * q.integrate(std::vector<double>(q.wavelength_nm.size(), r));
            for (std::size_t c = 0; c < 3; ++c) {
              const double want = space == RgbSpace::xyz ? r * vec(white)[c] : r;
              CHECK(std::abs(got[c] - want) <= 1e-12 * r);
            }
          }
        }
      }
  }
}

TEST_CASE("under an illuminant that is not the space's, Bradford comes first") {
  const Xyz a = discrete_white(Method::nm1, {Observer::cie1931_2deg, Illuminant::a});
  const Xyz white = discrete_white(Method::nm1, {});
  near(xyz_to_rgb(RgbSpace::rec2020, a, white),
       inverse(rgb_to_xyz(primaries(RgbSpace::rec2020), white)) * bradford(a, white), 1e-13);
  near(xyz_to_rgb(RgbSpace::acescg, white, white),
       inverse(rgb_to_xyz(primaries(RgbSpace::acescg), test::aces_white)) * bradford(white, test::aces_white),
       1e-13);
  near(xyz_to_rgb(RgbSpace::xyz, a, white), identity3, 0);
}

TEST_CASE("space names read back") {
  for (const RgbSpace space : all_rgb_spaces) CHECK(rgb_space_named(name(space)) == space);
  CHECK(name(RgbSpace::display_p3) == "display-p3");
  CHECK(!rgb_space_named("sRGB "));
}

TEST_CASE("common names of the spaces are known in any case") {
  for (const char* text : {"sRGB", "SRGB", "linear", "Linear sRGB", "Rec.709", "rec 709", "BT.709"})
    CHECK(rgb_space_named(text) == RgbSpace::srgb);
  for (const char* text : {"ACEScg", "AP1"}) CHECK(rgb_space_named(text) == RgbSpace::acescg);
  for (const char* text : {"Rec.2020", "BT2020"}) CHECK(rgb_space_named(text) == RgbSpace::rec2020);
  for (const char* text : {"Display P3", "DisplayP3", "P3-D65"})
    CHECK(rgb_space_named(text) == RgbSpace::display_p3);
  for (const char* text : {"XYZ", "CIE XYZ"}) CHECK(rgb_space_named(text) == RgbSpace::xyz);
  // Other primaries, other white, or a curve of their own.
  for (const char* text : {"ACES", "ACES2065-1", "DCI-P3", "Adobe RGB", "sRGB texture", "", " "})
    CHECK_FALSE(rgb_space_named(text));
}
