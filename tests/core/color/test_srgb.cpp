// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/color/srgb.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("all 256 codes of 8 bit and all 65536 of 16 bit survive decoding and encoding") {
  for (int code = 0; code < 256; ++code) {
    const double linear = srgb_decode(code / 255.0);
    REQUIRE(srgb_u8(linear) == code);
    REQUIRE(srgb_u8(static_cast<float>(linear)) == code);
  }
  for (int code = 0; code < 65536; ++code)
    REQUIRE(std::floor(65535 * srgb_encode(srgb_decode(code / 65535.0)) + 0.5) == code);
}

TEST_CASE("the curve has the constants of the standard") {
  CHECK(srgb_encode(0) == 0);
  CHECK(srgb_encode(1) == Approx(1).epsilon(1e-15));
  CHECK(srgb_encode(0.001) == Approx(0.01292).epsilon(1e-15));
  CHECK(srgb_encode(0.18) == Approx(1.055 * std::pow(0.18, 1 / 2.4) - 0.055).epsilon(1e-15));
  CHECK(srgb_decode(0.5) == Approx(std::pow((0.5 + 0.055) / 1.055, 2.4)).epsilon(1e-15));
  CHECK(srgb_decode(0.04) == Approx(0.04 / 12.92).epsilon(1e-15));
}

TEST_CASE("the two branches meet within 2.9e-8") {
  const double toe = 12.92 * 0.0031308, power = 1.055 * std::pow(0.0031308, 1 / 2.4) - 0.055;
  CHECK(std::abs(toe - power) < 3e-8);
  CHECK(srgb_encode(0.0031308) == Approx(toe).epsilon(1e-15));
  CHECK(std::abs(srgb_encode(std::nextafter(0.0031308, 1)) - srgb_encode(0.0031308)) < 3e-8);
}

TEST_CASE("the curve rises everywhere, outside [0, 1] too") {
  double before = srgb_encode(-0.5);
  for (double x = -0.499; x < 1.5; x += 0.001) {
    const double now = srgb_encode(x);
    REQUIRE(now > before - 3e-8);
    before = now;
  }
  CHECK(srgb_encode(-0.1) == Approx(-1.292).epsilon(1e-15));  // negative input stays on the toe
  CHECK(srgb_encode(1.022) > 1);
}

TEST_CASE("8-bit codes are rounded half up after encoding, and clipped") {
  CHECK(srgb_u8(0.0) == 0);
  CHECK(srgb_u8(1.0) == 255);
  CHECK(srgb_u8(-0.3) == 0);
  CHECK(srgb_u8(1.022) == 255);
  CHECK(srgb_u8(1e30) == 255);
  CHECK(srgb_u8(std::numeric_limits<double>::denorm_min()) == 0);
  // Half a code on the toe, where the arithmetic is plain.
  CHECK(srgb_u8(0.5 / 255 / 12.92 * (1 - 1e-12)) == 0);
  CHECK(srgb_u8(0.5 / 255 / 12.92 * (1 + 1e-12)) == 1);
  CHECK(srgb_u8(LinearRgb{1.022, 0.782, 0.344}) == Srgb8{255, 229, 158});
}

TEST_CASE("what is kept as it is becomes the nearest code, half up, and is clipped") {
  for (int code = 0; code < 256; ++code) CHECK(plain_u8(code / 255.0) == code);
  CHECK(plain_u8(0.5) == 128);
  CHECK(plain_u8(-1) == 0);
  CHECK(plain_u8(2) == 255);
}

TEST_CASE("each code covers the linear interval that rounds to it") {
  for (int code = 1; code < 256; ++code) {
    const double edge = srgb_decode((code - 0.5) / 255);
    REQUIRE(srgb_u8(edge * (1 - 1e-9)) == code - 1);
    REQUIRE(srgb_u8(edge * (1 + 1e-9)) == code);
  }
}

TEST_CASE("the printed blue of silicon is a rounding tie") {
  CHECK(255 * srgb_encode(0.426) == Approx(174.505).margin(5e-4));
  CHECK(srgb_u8(0.426) == 175);
  CHECK(srgb_u8(0.4259) == 174);
}

TEST_CASE("pure power codes are those of exponent 1/2.2") {
  CHECK(power22_u8(0.0) == 0);
  CHECK(power22_u8(1.0) == 255);
  CHECK(power22_u8(-1.0) == 0);
  CHECK(power22_u8(2.0) == 255);
  CHECK(power22_u8(std::pow(44 / 255.0, 2.2)) == 44);
  CHECK(power22_u8(0.5) == static_cast<int>(std::floor(255 * std::pow(0.5, 1 / 2.2) + 0.5)));
  CHECK(power22_u8(LinearRgb{1, 0, 0.5}) == Srgb8{255, 0, 186});
  // Schueler's water, 44, decoded as sRGB would be 24 % too bright.
  CHECK(std::pow(44 / 255.0, 2.2) == Approx(0.0210).margin(6e-4));
  CHECK(srgb_decode(44 / 255.0) == Approx(0.0252).margin(5e-5));
}

TEST_CASE("hexadecimal colours are written in lower case and read in every usual form") {
  CHECK(hex({255, 229, 158}) == "#ffe59e");
  CHECK(hex({0, 1, 16}) == "#000110");
  CHECK(parse_hex("#ffe59e") == Srgb8{255, 229, 158});
  CHECK(parse_hex("FFE59E") == Srgb8{255, 229, 158});
  CHECK(parse_hex("#fa0") == Srgb8{255, 170, 0});
  for (int code = 0; code < 256; ++code) {
    const auto c = static_cast<std::uint8_t>(code);
    const Srgb8 colour{c, static_cast<std::uint8_t>(255 - c), 7};
    REQUIRE(parse_hex(hex(colour)) == colour);
  }
  for (const auto* bad : {"", "#", "#ff", "#ffff", "#ffe59", "#ffe59e0", "##ffe59e", "ffe59g", "0xffe59e",
                          "#ffe59e ", " #ffe59e", "gold",
                          "#f\xc3\xa9"
                          "0"}) {
    INFO(bad);
    CHECK(!error_of([&] { parse_hex(bad); }).empty());
  }
}
