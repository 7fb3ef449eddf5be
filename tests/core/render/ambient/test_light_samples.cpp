// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/light_samples.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/render/environment.h"

namespace etak {

TEST_CASE("the dim part of an environment and its bright lights give the irradiance of the whole") {
  const Image map = environment_picture(*find_studio("sunset"), 256);
  const Environment whole(map, 1, "sunset", 2);
  const LightSamples apart = light_samples(map, true, 2);
  CHECK(apart.bright.size() == std::size_t{bright_count});
  for (const Vec3& n : {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-0.6, 0, 0.8}, Vec3{0, -0.8, 0.6}}) {
    Vec3 sum = apart.irradiance_at(n);
    for (const LightSamples::Bright& light : apart.bright)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += light.irradiance[c] * std::max(0.0, dot(light.from, n));
    const Vec3 expected = whole.irradiance(n);  // 128 places stand for the bright part
    for (std::size_t c = 0; c < 3; ++c) CHECK(sum[c] == Approx(expected[c]).epsilon(0.05));
  }
}

TEST_CASE("an even environment has no bright part") {
  CHECK(light_samples(Image(64, 32, 3, 0.4f), true, 2).bright.empty());
  CHECK(light_samples(Image(64, 32, 3, 0.0f), true, 2).bright.empty());
}

}  // namespace etak
