// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/ascii.h"

#include <catch2/catch.hpp>

using namespace etak;

TEST_CASE("letters of ASCII change their case, other bytes stay") {
  CHECK(lower_case("AZaz09 \xC3\x84") == "azaz09 \xC3\x84");
  CHECK(is_letter('z'));
  CHECK(!is_letter('\xE4'));
  CHECK(hex_digit('9') == 9);
  CHECK(hex_digit('f') == 15);
  CHECK(hex_digit('A') == 10);
  for (const char c : {'g', 'G', '/', ':', '@', '`', ' '}) CHECK(hex_digit(c) == -1);
}

TEST_CASE("what is trimmed are the ends alone") {
  CHECK(trimmed(" \ta b\t ") == "a b");
  CHECK(trimmed(" \t ").empty());
  CHECK(trimmed("a\n") == "a\n");
  CHECK(trimmed(" ., a.b ,", " .,") == "a.b");
}

TEST_CASE("an identifier has letters, digits and single separators inside") {
  CHECK(identifier("My sample (2).csv", '_') == "my_sample_2_csv");
  CHECK(identifier("--a--b--", '-') == "a-b");
  CHECK(identifier("\xC3\xA4 b", '_') == "b");
  CHECK(identifier("()", '_').empty());
}
