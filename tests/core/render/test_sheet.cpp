// SPDX-License-Identifier: Apache-2.0
#include "core/render/sheet.h"

#include <catch2/catch.hpp>

#include "core/color/delta_e.h"

using namespace etak;

namespace {

// A picture in the form of render_cpu(): one colour, which the object covers but for the first pixel.
Image plain_picture(float r, float g, float b) {
  Image out(8, 8, 4);
  for (std::size_t i = 0; i < out.pixel_count(); ++i) {
    out.values[4 * i] = r;
    out.values[4 * i + 1] = g;
    out.values[4 * i + 2] = b;
    out.values[4 * i + 3] = i == 0 ? 0.5f : 1;
  }
  return out;
}

}  // namespace

TEST_CASE("a picture has no difference from itself, and its map is black where the object is") {
  const Image picture = plain_picture(0.5f, 0.4f, 0.1f);
  const DifferencePicture none = difference_picture(picture, picture, 1);
  CHECK(none.mean_de == 0);
  CHECK(none.map.at(3, 3)[0] == 0);
  CHECK(none.map.at(0, 0)[0] > 0);  // the object covers half of it
}

TEST_CASE("the mean difference is CIEDE2000 of the displayed colours, exposed and clamped") {
  const Image dark = plain_picture(0.25f, 0.2f, 0.05f), bright = plain_picture(0.5f, 0.4f, 0.1f);
  const double expected = delta_e2000(to_lab(LinearRgb{0.5, 0.4, 0.1}), to_lab(LinearRgb{1, 0.8, 0.2}));
  CHECK(difference_picture(dark, bright, 2).mean_de == Approx(expected).margin(1e-5));
  // Both are above what a display shows.
  CHECK(difference_picture(plain_picture(1, 1, 1), plain_picture(3, 3, 3), 1).mean_de == 0);
}

TEST_CASE("the map stands at the right of its picture, and larger differences are brighter") {
  const Image picture = plain_picture(0.5f, 0.5f, 0.5f);
  const auto brightness = [&](float grey) {
    const Image map = difference_picture(picture, plain_picture(grey, grey, grey), 1).map;
    return map.at(4, 4)[0] + map.at(4, 4)[1] + map.at(4, 4)[2];
  };
  CHECK(brightness(0.55f) > 0);
  CHECK(brightness(0.7f) > brightness(0.55f));
  CHECK(brightness(0) > brightness(0.7f));
  const Image both = beside(picture, difference_picture(picture, picture, 1));
  CHECK(both.width == 16);
  CHECK(both.channels == 3);
  CHECK(both.at(4, 4)[0] == 0.5f);
}

TEST_CASE("cells of a sheet are as large as its largest picture") {
  const Image small = plain_picture(1, 1, 1);
  const Image wide = beside(small, difference_picture(small, small, 1));
  const Image sheet = laid_out({{"A", "B"}, {"ROW"}, {wide, small}});
  CHECK(sheet.width > 2 * wide.width);
  CHECK(sheet.height > small.height);
}
