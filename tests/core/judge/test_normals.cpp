// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/srgb.h"
#include "core/image/image.h"
#include "core/maps/normals.h"
#include "tests/core/judge/corpus.h"

using namespace etak;
using namespace etak::test;

namespace {

// Normals of bumps of a steepness; `store` turns a component, as 0..1, into its code.
template <class Store>
Image8 bumps(double steepness, Store store) {
  const int size = 128;
  Image8 out(size, size, 4, 255);
  each_texel(out, [&](auto texel, int x, int y) {
    const double dx = steepness * std::cos(x / 7.0) * std::cos(y / 9.0),
                 dy = -steepness * std::sin(x / 7.0) * std::sin(y / 9.0);
    const double length = std::sqrt(dx * dx + dy * dy + 1);
    const std::array<double, 3> n{-dx / length, -dy / length, 1 / length};
    for (std::size_t c = 0; c < 3; ++c) texel[c] = store(0.5 + 0.5 * n[c]);
  });
  return out;
}

std::uint8_t as_it_is(double value) {
  return to_byte(255 * value);
}

NormalFacts facts_of(const Image8& image) {
  NormalFacts facts;
  for (int y = 0; y < image.height; ++y) add_normals(facts, image.at(0, y).data(), image.width);
  return facts;
}

}  // namespace

TEST_CASE("a normal map stored right is right, from nearly flat to steep") {
  for (const double steepness : {0.001, 0.1, 0.5, 1.0, 3.0}) {
    const NormalFacts facts = facts_of(bumps(steepness, as_it_is));
    INFO("steepness " << steepness);
    CHECK(facts.texels == 128 * 128);
    CHECK(facts.not_unit == 0);
    CHECK(facts.below == 0);
    CHECK(facts.outside == 0);
    CHECK(normal_codes(facts) == NormalCodes::as_is);
    CHECK(std::abs(facts.mean(0)) < 0.1);
    CHECK(facts.mean(2) > 0.3);
    CHECK(std::abs(std::sqrt(static_cast<double>(facts.shortest)) / 255 - 1) < 0.0069);
    CHECK(std::abs(std::sqrt(static_cast<double>(facts.longest)) / 255 - 1) < 0.0069);
    CHECK_FALSE(is_constant(facts));
  }
}

TEST_CASE("a normal map that went through sRGB's curve is told, in both directions") {
  for (const double steepness : {0.01, 0.3, 1.0}) {
    INFO("steepness " << steepness);
    CHECK(normal_codes(facts_of(bumps(steepness, [](double v) { return srgb_u8(v); }))) ==
          NormalCodes::encoded);
    CHECK(normal_codes(facts_of(bumps(steepness, [](double v) { return as_it_is(srgb_decode(v)); }))) ==
          NormalCodes::decoded);
  }
  CHECK(normal_codes(facts_of(Image8(4, 4, 4, 188))) == NormalCodes::unclear);  // z is 188 too
  Image8 flat(4, 4, 4, 188);
  each_texel(flat, [](auto texel, int, int) { texel[2] = 255; });
  CHECK(normal_codes(facts_of(flat)) == NormalCodes::encoded);
}

TEST_CASE("normals of another length are counted, and a picture that is no normal map is unclear") {
  // Halved contrast: x and y shrink, and with them the length.
  Image8 weak = bumps(1.0, as_it_is);
  each_texel(weak, [](auto texel, int, int) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(127.5 + (texel[c] - 127.5) / 2);
  });
  const NormalFacts facts = facts_of(weak);
  CHECK(facts.not_unit == facts.texels);
  CHECK(std::sqrt(static_cast<double>(facts.longest)) / 255 == Approx(0.5).margin(0.01));
  Image8 noise(128, 128, 4);
  Random random(3);
  for (std::uint8_t& v : noise.values) v = to_byte(random.below(256));
  const NormalFacts no_map = facts_of(noise);
  CHECK(normal_codes(no_map) == NormalCodes::unclear);
  CHECK(no_map.below > no_map.texels / 3);
  CHECK_FALSE(normal_codes(NormalFacts{}).has_value());
}

TEST_CASE("normals that point into the surface are counted from code 126 down") {
  Image8 image(4, 1, 4, 128);
  for (int x = 0; x < 4; ++x) image.at(x, 0)[2] = to_byte(125 + x);
  CHECK(facts_of(image).below == 2);
}

TEST_CASE("maps of two channels are known by their constant blue") {
  for (const int blue : {0, 255}) {
    Image8 image = bumps(0.8, as_it_is);
    each_texel(image, [&](auto texel, int, int) { texel[2] = to_byte(blue); });
    const NormalFacts facts = facts_of(image);
    CHECK(normal_codes(facts) == NormalCodes::two_channels);
    CHECK(facts.outside == 0);
  }
  // Flat with blue 255 is a whole normal map.
  Image8 flat(8, 8, 4, 128);
  each_texel(flat, [](auto texel, int, int) { texel[2] = 255; });
  CHECK(normal_codes(facts_of(flat)) == NormalCodes::as_is);
  CHECK(is_constant(facts_of(flat)));
}

TEST_CASE("flat areas of codes 127 and 128 in one map are told") {
  Image8 image(64, 64, 4, 128);
  each_texel(image, [](auto texel, int x, int) {
    texel[0] = x < 32 ? 127 : 128;
    texel[2] = 255;
  });
  const NormalFacts both = facts_of(image);
  CHECK(both.flat == 64 * 64);
  CHECK(both.flat_codes[0] == std::array<std::uint64_t, 2>{2048, 2048});
  CHECK(both.flat_codes[1] == std::array<std::uint64_t, 2>{0, 4096});
  CHECK(is_flat_in_two_codes(both));
  each_texel(image, [](auto texel, int, int) { texel[0] = 127; });
  CHECK_FALSE(is_flat_in_two_codes(facts_of(image)));
  CHECK_FALSE(is_flat_in_two_codes(facts_of(bumps(1, as_it_is))));
}

TEST_CASE("facts of halves add up to those of the whole") {
  const Image8 image = bumps(2, as_it_is);
  NormalFacts top, bottom;
  for (int y = 0; y < image.height; ++y)
    add_normals(y < 50 ? top : bottom, image.at(0, y).data(), image.width);
  bottom.add(top);
  CHECK(bottom == facts_of(image));
  NormalFacts none;
  none.add(bottom);
  CHECK(none == bottom);
}
