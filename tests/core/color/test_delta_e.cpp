// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"

using namespace etak;

namespace {
struct Pair {
  Lab a, b;
  double difference;
};

// Sharma, Wu and Dalal 2005, table 1.
const std::array<Pair, 34> sharma{{
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
}};
}  // namespace

TEST_CASE("CIEDE2000 gives the 34 printed differences of Sharma, Wu and Dalal, both ways round") {
  for (std::size_t i = 0; i < sharma.size(); ++i) {
    INFO("pair " << i + 1);
    CHECK(delta_e2000(sharma[i].a, sharma[i].b) == Approx(sharma[i].difference).margin(1e-4));
    CHECK(delta_e2000(sharma[i].b, sharma[i].a) == Approx(sharma[i].difference).margin(1e-4));
  }
}

TEST_CASE("the difference is symmetric, never negative, and zero only for equal colours") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> l(0, 100), ab(-100, 100);
  for (int i = 0; i < 5000; ++i) {
    const Lab a{l(random), ab(random), ab(random)}, b{l(random), ab(random), ab(random)};
    const double there = delta_e2000(a, b);
    REQUIRE(there > 0);
    REQUIRE(there == Approx(delta_e2000(b, a)).epsilon(1e-9));
    REQUIRE(delta_e2000(a, a) == 0);
  }
  CHECK(delta_e2000({}, {}) == 0);
}

TEST_CASE("around a colour, the squares of small differences are those of their matrix") {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> l(0, 100), ab(-100, 100), off(-0.01, 0.01);
  for (int i = 0; i < 2000; ++i) {
    const double size = i % 4 == 0 ? 0.2 : 1;  // nearly grey, too
    const Lab at{l(random), size * ab(random), size * ab(random)};
    const Vec3 way{off(random), off(random), off(random)};
    const Lab low{at.l - way[0] / 2, at.a - way[1] / 2, at.b - way[2] / 2},
        high{at.l + way[0] / 2, at.a + way[1] / 2, at.b + way[2] / 2};
    const Mat3 metric = delta_e2000_around(at);
    REQUIRE(std::sqrt(dot(way, metric * way)) == Approx(delta_e2000(low, high)).epsilon(2e-3));
    REQUIRE(metric[1][2] == metric[2][1]);
  }
  CHECK(delta_e2000_around({50, 0, 0}) == diagonal({1, 2.25, 1}));
}

TEST_CASE("white is L* 100 and grey has no chroma") {
  const Xyz white{0.95, 1, 1.09};
  const Lab lab = to_lab(white, white);
  CHECK(lab.l == Approx(100).epsilon(1e-14));
  CHECK(std::abs(lab.a) < 1e-12);
  CHECK(std::abs(lab.b) < 1e-12);
  for (const double grey : {1.0, 0.18, 0.008, 1e-4, 0.0}) {
    const Lab g = to_lab(LinearRgb{grey, grey, grey});
    CHECK(std::abs(g.a) < 1e-9);
    CHECK(std::abs(g.b) < 1e-9);
    // CIE 15: L* = 116 Y^(1/3) - 16 above (6/29)^3, 903.3 Y below.
    CHECK(g.l ==
          Approx(grey > 216.0 / 24389 ? 116 * std::cbrt(grey) - 16 : 24389.0 / 27 * grey).margin(1e-10));
  }
}

TEST_CASE("the Lab values of the sRGB primaries are the known ones") {
  const auto near = [](const Lab& got, const Lab& want) {
    CHECK(got.l == Approx(want.l).margin(0.02));
    CHECK(got.a == Approx(want.a).margin(0.05));
    CHECK(got.b == Approx(want.b).margin(0.05));
  };
  near(to_lab(LinearRgb{1, 0, 0}), {53.24, 80.09, 67.20});
  near(to_lab(LinearRgb{0, 1, 0}), {87.73, -86.18, 83.18});
  near(to_lab(LinearRgb{0, 0, 1}), {32.30, 79.19, -107.86});
}
