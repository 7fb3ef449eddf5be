// SPDX-License-Identifier: Apache-2.0
#include "core/image/dilate.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/color/srgb.h"
#include "core/image/mips.h"
#include "tests/core/image/mip_reference.h"

namespace etak {
namespace {

using test::noise_picture;

}  // namespace

TEST_CASE("a gutter repeats the nearest texel of its box, and nothing else changes") {
  for (const int channels : {1, 3, 4}) {
    Image8 page(20, 15, channels);
    test::Noise noise{3};
    for (auto& code : page.values) code = noise.code();
    const Image8 before = page;
    const PixelBox box{1, 6, 7, 5};  // nearer to the page's edge than the gutter
    replicate_edges(view(page), box, {0, 3, 11, 11});
    for (int y = 0; y < 15; ++y)
      for (int x = 0; x < 20; ++x) {
        const bool cell = x < 11 && y >= 3 && y < 14;
        const int u = cell ? std::clamp(x, 1, 7) : x, v = cell ? std::clamp(y, 6, 10) : y;
        for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
          REQUIRE(page.at(x, y)[c] == before.at(u, v)[c]);
      }
  }
}

TEST_CASE("a gutter of floats is that of codes") {
  Image8 codes = noise_picture(12, 9, 1);
  Image floats(12, 9, 4);
  std::copy(codes.values.begin(), codes.values.end(), floats.values.begin());
  const PixelBox box{3, 2, 5, 4}, cell{1, 0, 10, 9};
  replicate_edges(view(codes), box, cell);
  replicate_edges(view(floats), box, cell);
  CHECK(std::equal(codes.values.begin(), codes.values.end(), floats.values.begin()));
}

TEST_CASE("no gutter and a single texel are gutters too") {
  Image8 page = noise_picture(5, 5, 1);
  const Image8 before = page;
  replicate_edges(view(page), {1, 1, 3, 3}, {1, 1, 3, 3});
  CHECK(page == before);
  replicate_edges(view(page), {2, 2, 1, 1}, {0, 0, 5, 5});
  for (std::size_t i = 0; i < page.values.size(); ++i) REQUIRE(page.values[i] == before.at(2, 2)[i % 4]);
}

TEST_CASE("bleeding leaves visible texels and every opacity alone") {
  Image8 a = noise_picture(61, 40, 1), b = noise_picture(61, 40, 2);
  for (std::size_t i = 3; i < a.values.size(); i += 4)
    if (a.values[i] < 150) a.values[i] = 0;
  const Image8 a0 = a, b0 = b;
  std::size_t hidden = 0;
  const std::size_t filled = bleed_under_alpha(a, b);
  for (std::size_t i = 0; i < a.values.size(); i += 4) {
    REQUIRE(a.values[i + 3] == a0.values[i + 3]);
    if (a0.values[i + 3] == 0) {
      ++hidden;
      continue;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      REQUIRE(a.values[i + c] == a0.values[i + c]);
      REQUIRE(b.values[i + c] == b0.values[i + c]);
    }
  }
  CHECK(filled == hidden);
  const Image8 a1 = a, b1 = b;
  CHECK(bleed_under_alpha(a, b) == hidden);
  CHECK(a == a1);
  CHECK(b == b1);
}

TEST_CASE("hidden texels get the mean of the smallest block with something visible in it") {
  Image8 a(6, 5, 4, 0), b(6, 5, 4, 0);
  const auto show = [&](int x, int y, std::uint8_t code) {
    for (auto& v : a.at(x, y)) v = code;
    for (auto& v : b.at(x, y)) v = code;
    a.at(x, y)[3] = 1;  // a texel of alpha 1 is visible too
  };
  show(0, 0, 255);
  show(1, 1, 0);
  show(3, 0, 77);
  CHECK(bleed_under_alpha(a, b) == 27);
  CHECK(int{a.at(1, 0)[0]} == 188);  // half the light of white
  CHECK(int{b.at(0, 1)[2]} == 188);
  CHECK(int{b.at(0, 1)[3]} == 21);  // the mean of 1/e, as in the mips
  CHECK(int{a.at(2, 1)[1]} == 77);
  CHECK(int{b.at(2, 0)[3]} == 77);
  // Texel (0, 2) is filled from the block of 4 x 4, the mean of two blocks; texel (5, 4) from the whole
  // picture.
  CHECK(a.at(0, 2)[0] == a.at(3, 3)[0]);
  CHECK(int{a.at(0, 2)[0]} > 77);
  CHECK(a.at(5, 4)[0] == a.at(0, 2)[0]);
}

TEST_CASE("a picture of one colour is filled with just that colour") {
  for (int code = 0; code < 256; ++code) {
    Image8 a(9, 9, 4, static_cast<std::uint8_t>(code)), b = a;
    for (std::size_t i = 0; i < a.values.size(); i += 4) a.values[i + 3] = i % 7 == 0 ? 255 : 0;
    for (std::size_t i = 0; i < a.values.size(); i += 4)
      if (a.values[i + 3] == 0) a.values[i] = b.values[i + 3] = 3;
    bleed_under_alpha(a, b);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      if (i % 4 != 3) REQUIRE(int{a.values[i]} == code);
      REQUIRE(int{b.values[i]} == code);
    }
  }
}

TEST_CASE("nothing visible or nothing hidden: nothing changes; texture B may be absent") {
  for (const int alpha : {0, 255}) {
    Image8 a = noise_picture(16, 8, 1), b = noise_picture(16, 8, 2);
    for (std::size_t i = 3; i < a.values.size(); i += 4) a.values[i] = static_cast<std::uint8_t>(alpha);
    const Image8 a0 = a, b0 = b;
    CHECK(bleed_under_alpha(a, b) == 0);
    CHECK(a == a0);
    CHECK(b == b0);
  }
  Image8 a = noise_picture(16, 8, 1), b = noise_picture(16, 8, 2), same = a;
  for (std::size_t i = 3; i < a.values.size(); i += 8) same.values[i] = a.values[i] = 0;
  bleed_under_alpha(a, b);
  bleed_under_alpha(view(same), {});
  CHECK(a == same);
}

TEST_CASE("floats bleed as codes do, unrounded and beyond 0..1") {
  Image8 a = noise_picture(61, 40, 1), b = noise_picture(61, 40, 2);
  for (std::size_t i = 3; i < a.values.size(); i += 4)
    if (a.values[i] < 220) a.values[i] = 0;
  const auto floats = [](const Image8& codes) {
    Image out(codes.width, codes.height, 4);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
      const double v = codes.values[i] / 255.0;
      out.values[i] = static_cast<float>(i % 4 == 3 ? v : srgb_decode(v));
    }
    return out;
  };
  Image wide_a = floats(a), wide_b = floats(b);
  const Image before = wide_a;
  CHECK(bleed_under_alpha(wide_a, wide_b) == bleed_under_alpha(a, b));
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const auto code = [&](const Image& wide) {
      const double v = double{wide.values[i]};
      return 255 * (i % 4 == 3 ? v : srgb_encode(v));
    };
    REQUIRE(code(wide_a) == Approx(a.values[i]).margin(0.51));
    REQUIRE(code(wide_b) == Approx(b.values[i]).margin(0.51));
    if (before.values[i - i % 4 + 3] > 0) REQUIRE(wide_a.values[i] == before.values[i]);
  }
  Image bright(2, 1, 4, 3.5f), other(2, 1, 4, -0.25f);
  bright.at(1, 0)[0] = 0, bright.at(1, 0)[3] = 0, other.at(1, 0)[2] = 7;
  CHECK(bleed_under_alpha(bright, other) == 1);
  CHECK(double{bright.at(1, 0)[0]} == 3.5);
  CHECK(double{other.at(1, 0)[2]} == -0.25);
  CHECK(double{other.at(1, 0)[3]} == Approx(-0.25));
}

TEST_CASE("bleeding works inside a box of a page") {
  Image8 page = noise_picture(40, 40, 1), other = noise_picture(40, 40, 2);
  const PixelBox box{5, 7, 20, 11};
  page.at(9, 9)[3] = 0;
  const Image8 before = page;
  bleed_under_alpha(view(page).part(box), view(other).part(box));
  std::size_t changed = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        if (page.at(x, y)[c] != before.at(x, y)[c]) {
          ++changed;
          CHECK((x >= 5 && x < 25 && y >= 7 && y < 18));
          CHECK(before.at(x, y)[3] == 0);
        }
  CHECK(changed > 0);
}

}  // namespace etak
