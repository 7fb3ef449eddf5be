// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/pack/blocks/budget.h"

using namespace etak;

TEST_CASE("a percentile of block errors counts texels by how much of them triangles read") {
  Spread spread(0.01);
  for (int i = 0; i < 980; ++i) spread.add(0.5, 255);
  for (int i = 0; i < 20; ++i) spread.add(3, 100);  // 2 % of the texels, 0.8 % of what is read
  CHECK(spread.count() == 980 * 255 + 20 * 100);
  CHECK(spread.percentile_99() == 0.5);
  CHECK(spread.largest() == 3);
  CHECK(spread.above(1) == 2000);
  for (int i = 0; i < 20; ++i) spread.add(3, 255);
  CHECK(spread.percentile_99() == 3);
}
