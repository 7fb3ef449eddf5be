// SPDX-License-Identifier: Apache-2.0
#include "core/base/text.h"

#include <catch2/catch.hpp>
#include <limits>

using namespace etak;

TEST_CASE("found 1.11: numbers with fixed decimals stay short, however large they are") {
  CHECK(fixed(0.5, 1) == "0.5");
  CHECK(fixed(-0.001, 2) == "0.00");
  CHECK(fixed(999999999999999, 1) == "999999999999999.0");
  CHECK(fixed(-999999999999999, 30).size() == 47);
  CHECK(fixed(1e15, 4) == "1e+15");
  CHECK(fixed(std::numeric_limits<double>::max(), 4) == "1.79769e+308");
  CHECK(fixed(std::numeric_limits<double>::lowest(), 4) == "-1.79769e+308");
  CHECK(fixed(std::numeric_limits<double>::infinity(), 4) == "inf");
  CHECK(fixed(std::numeric_limits<double>::quiet_NaN(), 4) == "nan");
}
