// SPDX-License-Identifier: Apache-2.0
#include "core/math/functions.h"
#include "core/render/ambient/round_lobe.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace etak {
namespace {

#include "core/render/ambient/ambient_text.h"

}  // namespace

TEST_CASE("a plane through a lobe's axis halves it, and the two sides of any plane are the whole") {
  for (double level = 0; level <= lobe_levels - 1; level += 0.5) {
    CHECK(share_beyond(level, 0) == Approx(0.5).epsilon(1e-6));
    double before = 0;
    for (double angle = -1.5; angle < 1.55; angle += 0.1) {
      const double here = share_beyond(level, angle);
      CHECK(here + share_beyond(level, -angle) == Approx(1).epsilon(1e-9));
      CHECK(here >= before);
      before = here;
    }
  }
}

TEST_CASE("the lobe of exponent 2 is the cosine, of which (1 + sin) / 2 lies beyond a plane") {
  CHECK(round_lobe(2, 0.3) == Approx(0.3));
  CHECK(round_lobe(2, -0.3) == 0);
  const double level = level_of_gloss(1.0 / 12);
  for (const double angle : {-1.2, -0.5, 0.2, 0.7, 1.4})
    CHECK(share_beyond(level, angle) == Approx((1 + std::sin(angle)) / 2).margin(0.01));
}

TEST_CASE("the shader's share of a lobe beyond a plane is that of the integral") {
  for (double level = 0; level <= lobe_levels - 1; level += 0.25)
    for (double angle = -1.5; angle <= 1.5; angle += 0.02) {
      CAPTURE(level, angle);
      CHECK(ambient_text::probe_share(std::sin(angle), level) ==
            Approx(share_beyond(level, angle)).margin(0.022));
    }
}

}  // namespace etak
