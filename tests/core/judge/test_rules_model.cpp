// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/brdf/integrals/albedo.h"
#include "core/color/srgb.h"
#include "tests/core/judge/corpus.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("the table of the model's albedo is what the model integrates to") {
  // White with F0 0.04: what is left for diffuse is 1.001 minus the specular albedo at the worst of four
  // angles.
  const Model& model = *find_model(default_specular);
  for (const auto& [gloss, width] : {std::pair(0.5, 0.2), std::pair(1.0, 0.05)}) {
    double worst = 0;
    for (const double angle : {0.0, 60.0, 80.0, 85.0}) {
      AlbedoOptions options;
      options.error = 1e-3;
      options.lobe_width = width;
      const double values[4] = {0.04, 0.04, 0.04, gloss};
      worst = std::max(worst, directional_albedo(
                                  [&](const Directions& d) {
                                    double rgb[3];
                                    model.f64(d, values, rgb);
                                    return rgb[0];
                                  },
                                  angle, options));
    }
    for (const double difference : {-0.03, 0.03}) {
      const int diffuse = srgb_u8(1.001 - worst + difference), f0 = srgb_u8(0.04);
      TextureSet set = flat_set(16, {f0, f0, f0}, {diffuse, diffuse, diffuse});
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) set.b.at(x, y)[3] = static_cast<std::uint8_t>(std::lround(255 * gloss));
      INFO("gloss " << gloss << ", albedo " << worst << ", diffuse " << diffuse);
      CHECK(found(check_set(set), "ETK206") == (difference > 0));
    }
  }
}
