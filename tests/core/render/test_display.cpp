// SPDX-License-Identifier: Apache-2.0
#include "core/render/display.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/color/srgb.h"

namespace etak {

TEST_CASE("codes by table are the codes of the curve, around every boundary too") {
  Image picture(1, 1, 3);
  for (int i = 0; i <= 20000; ++i) {
    const float value = static_cast<float>(i) / 19000;
    picture.values = {value, std::nextafter(value, 2.0f), std::nextafter(value, -1.0f)};
    const Image8 codes = to_codes(picture, 1, Transfer::srgb);
    for (std::size_t c = 0; c < 3; ++c) REQUIRE(codes.values[c] == srgb_u8(double{picture.values[c]}));
  }
  for (int code = 1; code < 256; ++code) {
    const auto at = static_cast<float>(srgb_decode((code - 0.5) / 255));
    picture.values = {at, at * (1 - 1e-6f), at * (1 + 1e-6f)};
    const Image8 codes = to_codes(picture, 1, Transfer::srgb);
    for (std::size_t c = 0; c < 3; ++c) REQUIRE(codes.values[c] == srgb_u8(double{picture.values[c]}));
  }
}

TEST_CASE("every transfer has each of its 256 codes, in order, and changes by one code at a time") {
  for (const Transfer each : {Transfer::srgb, Transfer::power_045, Transfer::square_root, Transfer::linear}) {
    Image picture(1, 1, 3);
    int before = 0;
    // The steps are far smaller than a code, also near black, where the curves are steep.
    for (float value = 1e-8f; value < 1.1f; value *= 1.0005f) {
      picture.values = {value, value, value};
      const int code = to_codes(picture, 1, each).values[0];
      REQUIRE((code == before || code == before + 1));
      before = code;
    }
    CHECK(before == 255);
  }
}

TEST_CASE("Schueler's shortcuts are the powers they are named for, and exposure is a factor before them") {
  Image picture(1, 1, 3);
  picture.values = {0.25f, 0.04f, 1};
  CHECK(to_codes(picture, 1, Transfer::square_root).values == std::vector<std::uint8_t>{128, 51, 255});
  CHECK(to_codes(picture, 1, Transfer::linear).values == std::vector<std::uint8_t>{64, 10, 255});
  CHECK(to_codes(picture, 2, Transfer::linear).values[0] == 128);
  CHECK(int{to_codes(picture, 1, Transfer::power_045).values[1]} ==
        static_cast<int>(std::floor(255 * std::pow(0.04, 0.45) + 0.5)));
}

TEST_CASE("what no display shows becomes black or white") {
  Image picture(1, 1, 4);
  picture.values = {std::numeric_limits<float>::quiet_NaN(), -1, std::numeric_limits<float>::infinity(), 0};
  CHECK(to_codes(picture, 1, Transfer::srgb).values == std::vector<std::uint8_t>{0, 0, 255});
}

TEST_CASE("transfers are found by their names") {
  for (const Transfer each : {Transfer::srgb, Transfer::power_045, Transfer::square_root, Transfer::linear})
    CHECK(transfer_named(name(each)) == each);
  CHECK_FALSE(transfer_named("gamma"));
}

}  // namespace etak
