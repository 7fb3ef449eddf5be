// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/prefilter.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/light/studio.h"
#include "core/render/ambient/lat_long.h"
#include "core/render/environment.h"

namespace etak {

TEST_CASE("a stack of octahedral maps has the values of its maps, and is linear between them") {
  const Image map = environment_picture(*find_studio("studio"), 256), other(64, 32, 3, 2.0f);
  constexpr int tile = 322;
  const Image stack = stacked({&map, &other}, tile, 2);
  for (const Vec3& d : {Vec3{0.3, 0.4, 0.866}, Vec3{-0.7, -0.5, 0.51}, Vec3{0.02, -0.99, 0.14}}) {
    const double sharp = look_up(map, place_of(d))[1];
    CHECK(in_stack(stack, tile, d, 0)[1] == Approx(sharp).epsilon(0.02).margin(1e-3));
    CHECK(in_stack(stack, tile, scaled(d, 5), 0.25)[1] == Approx(0.75 * sharp + 0.5).epsilon(0.02));
    CHECK(in_stack(stack, tile, d, 1)[1] == Approx(2));
  }
}

}  // namespace etak
