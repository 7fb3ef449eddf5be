// SPDX-License-Identifier: Apache-2.0
// Whether a picture of colours holds normals.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/maps/other_content.h"
#include "tests/core/judge/corpus.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

NormalSums sums_of(const Image8& picture) {
  NormalSums out;
  for (std::size_t i = 0; i < picture.values.size(); i += 3) out.add(picture.values.data() + i);
  return out;
}

constexpr int waves_side = 96;

// Normals of two waves of this slope, which run along (right, down).
Image8 waves(double slope, double right, double down, double noise, Random& random) {
  Image8 out(waves_side, waves_side, 3);
  each_texel(out, [&](auto texel, int x, int y) {
    const double lean = slope * std::cos(0.3 * (right * x + down * y)),
                 across = 0.6 * slope * std::cos(0.2 * (down * x - right * y));
    const std::array<double, 3> n{right * lean + down * across, down * lean - right * across, 1};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + 1);
    for (std::size_t c = 0; c < 3; ++c)
      texel[c] = to_byte(127.5 + 127.5 * n[c] / length + noise * random.between(-1, 1));
  });
  return out;
}

}  // namespace

TEST_CASE("normals of any direction and depth are told from colours, after a lossy format too") {
  Random random(4);
  for (const double slope : {0.025, 0.06, 0.2, 0.5, 1.0, 2.0})
    for (const double turn : {0.0, 0.4, 0.785, 1.2})
      for (const double noise : {0.0, slope < 0.05 ? 0.5 : slope < 0.2 ? 1.0 : 4.0}) {
        CAPTURE(slope, turn, noise);
        CHECK(are_normals(sums_of(waves(slope, std::cos(turn), std::sin(turn), noise, random))));
      }
}

TEST_CASE("colours of every hue are no normals, those of a flat normal map not either") {
  Random random(8);
  int taken = 0;
  for (int i = 0; i < 3000; ++i) {
    // From i = 1000 on about the colour of a flat normal map, where lengths are near 1.
    const bool near = i >= 1000;
    const std::array<double, 3> base{near ? random.between(100, 155) : random.between(0, 255),
                                     near ? random.between(100, 155) : random.between(0, 255),
                                     near ? random.between(225, 250) : random.between(0, 255)};
    const double bright = random.between(0, 40), hue = random.between(0, 6);
    NormalSums sums;
    for (int texel = 0; texel < 4000; ++texel) {
      const double by = bright * random.between(-1, 1) / 255;
      std::array<std::uint8_t, 3> codes{};
      for (std::size_t c = 0; c < 3; ++c)
        codes[c] = to_byte(base[c] * (1 + by) + hue * random.between(-1, 1));
      sums.add(codes.data());
    }
    taken += are_normals(sums);
  }
  CHECK(taken == 0);
}

TEST_CASE("a picture of one colour is none of normals, nor is one without a texel") {
  CHECK_FALSE(are_normals({}));
  for (const auto& colour : {std::array{128, 128, 255}, std::array{200, 128, 220}}) {
    NormalSums sums;
    for (int i = 0; i < 100; ++i) {
      const std::array codes{static_cast<std::uint8_t>(colour[0]), static_cast<std::uint8_t>(colour[1]),
                             static_cast<std::uint8_t>(colour[2])};
      sums.add(codes.data());
    }
    CHECK_FALSE(are_normals(sums));
  }
}
