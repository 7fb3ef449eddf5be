// SPDX-License-Identifier: Apache-2.0
#include "core/image/image.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace etak {
namespace {

Image ramp(int width, int height) {
  Image out(width, height, 1);
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = static_cast<float>(i);
  return out;
}

}  // namespace

TEST_CASE("shrinking keeps the mean, for sides that do not divide too") {
  const Image image = ramp(7, 5);
  for (const auto& [width, height] : {std::pair{7, 5}, {3, 2}, {1, 1}, {2, 5}}) {
    const Image small = shrunk(image, width, height);
    double sum = 0;
    for (const float v : small.values) sum += double{v};
    CHECK(sum / static_cast<double>(small.values.size()) == Approx(17).epsilon(1e-6));
  }
  CHECK(shrunk(image, 7, 5) == image);
}

TEST_CASE("pasting leaves out what lies outside") {
  const Image part = ramp(3, 3);
  Image whole(4, 4, 1, -1);
  paste(part, -1, 2, whole);
  CHECK(whole.at(0, 2)[0] == 1);
  CHECK(whole.at(1, 3)[0] == 5);
  CHECK(whole.at(2, 2)[0] == -1);
  CHECK(whole.at(0, 1)[0] == -1);
  paste(part, 10, 0, whole);
  CHECK(whole.at(3, 0)[0] == -1);
}

TEST_CASE("codes are rounded half up, and what is no number is 0") {
  CHECK(to_code(0) == 0);
  CHECK(to_code(1) == 255);
  CHECK(to_code(0.5f) == 128);
  CHECK(to_code(-3) == 0);
  CHECK(to_code(7) == 255);
  CHECK(to_code(std::numeric_limits<float>::quiet_NaN()) == 0);
  CHECK(to_code(std::numeric_limits<float>::infinity()) == 255);
}

}  // namespace etak
