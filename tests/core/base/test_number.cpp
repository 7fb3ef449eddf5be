// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/base/number.h"

using namespace etak;

namespace {
bool reads(std::string_view text, double expected) {
  double value = 0;
  return parse_number(text, value) && value == expected && std::signbit(value) == std::signbit(expected);
}
bool refuses(std::string_view text) {
  double value = 42;
  return !parse_number(text, value);
}
}  // namespace

TEST_CASE("a decimal number is read whole and exactly") {
  CHECK(reads("1.5", 1.5));
  CHECK(reads("-2e-3", -2e-3));
  CHECK(reads("+3", 3));
  CHECK(reads("0", 0));
  CHECK(reads("-0", -0.0));
  CHECK(reads(".5", 0.5));
  CHECK(reads("5.", 5));
  CHECK(reads("1E+02", 100));
  CHECK(reads("0.1879", 0.1879));
  CHECK(reads("4.9406564584124654e-324", std::numeric_limits<double>::denorm_min()));
}

TEST_CASE("what is no finite number is refused") {
  for (const auto* text : {"",         " ",     "1 ",     " 1",   "1,5",   "nan",   "NaN", "inf", "-inf",
                           "Infinity", "1e999", "-1e999", "0x10", "1.5.2", "--1",   "+-1", "-+1", "++1",
                           "+",        "-",     "e5",     "1e",   "1e+",   "1_000", "1d3"}) {
    INFO(text);
    CHECK(refuses(text));
  }
  CHECK(refuses(std::string_view("1\0", 2)));
}

TEST_CASE("numbers are printed as printf's %.Ng prints them in the C locale") {
  CHECK(number(0, 9) == "0");
  CHECK(number(1, 9) == "1");
  CHECK(number(1.0 / 3, 9) == "0.333333333");
  CHECK(number(-1.0 / 3, 4) == "-0.3333");
  CHECK(number(1e-7, 9) == "1e-07");
  CHECK(number(123456789012.0, 9) == "1.23456789e+11");
  CHECK(number(0.0001, 9) == "0.0001");
  std::string text = "x=";
  append_number(text, 2.5, 3);
  CHECK(text == "x=2.5");

  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (int i = 0; i < 2000; ++i) {
    const double value = (i % 2 ? -1 : 1) * std::pow(10, exponent(random));
    for (const int digits : {1, 6, 9, 17}) {
      std::array<char, 64> expected{};
      std::snprintf(expected.data(), expected.size(), "%.*g", digits, value);
      REQUIRE(number(value, digits) == expected.data());
    }
  }
}

TEST_CASE("seventeen digits read back equal") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 2000; ++i) {
    double value = 0, back = 0;
    const std::uint64_t bits = random();
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    REQUIRE(parse_number(number(value, 17), back));
    REQUIRE(back == value);
  }
}

TEST_CASE("locale plays no part in numbers") {
  const char* set = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  if (set == nullptr) WARN("no German locale here; checked under the C locale only");
  CHECK(number(1.5, 9) == "1.5");
  CHECK(reads("1.5", 1.5));
  CHECK(refuses("1,5"));
  std::setlocale(LC_NUMERIC, "C");
}
