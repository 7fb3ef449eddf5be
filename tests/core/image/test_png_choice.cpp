// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_choice.h"

#include <catch2/catch.hpp>

#include "core/image/image_io.h"
#include "core/image/load.h"
#include "tests/core/image/png_of.h"
#include "tests/support.h"

using namespace etak;

namespace {

std::uint32_t scrambled(std::uint32_t i) {
  i = (i ^ i >> 15) * 0x2C1B3C6DU;
  i = (i ^ i >> 12) * 0x297A2D39U;
  return i ^ i >> 15;
}

// A picture whose texels are drawn from `colours`, each of as many values as channels.
Image8 drawn(int width, int height, const std::vector<std::vector<std::uint8_t>>& colours) {
  Image8 out(width, height, static_cast<int>(colours[0].size()));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto& from = colours[scrambled(static_cast<std::uint32_t>(y * width + x)) % colours.size()];
      std::copy(from.begin(), from.end(), out.at(x, y).begin());
    }
  return out;
}

// As another decoder reads it.
Image8 read_by_others(const std::string& bytes) {
  const Picture picture = picture_door().bytes(bytes, "t.png");
  return std::get<Image8>(picture.pixels);
}

std::string file_of(const PackedPng& packed, PngLevel level) {
  PngOptions options;
  options.level = level;
  options.palette = packed.palette;
  return png_bytes(packed.view(), options);
}

}  // namespace

TEST_CASE("packed pictures read as the same channels and codes, at every width of a byte's codes") {
  for (const int width : {1, 3, 7, 8, 9, 17, 64})
    for (const PngLevel level : {PngLevel::fast, PngLevel::small, PngLevel::smallest}) {
      const auto check = [&](const std::vector<std::vector<std::uint8_t>>& colours, int bits, bool palette) {
        const Image8 image = drawn(width, 11, colours);
        INFO(width << " " << bits << " " << palette);
        const auto packed = packed_png(image);
        REQUIRE(packed);
        CHECK(packed->header.bits <= bits);
        CHECK(packed->palette.empty() != palette);
        CHECK(read_by_others(file_of(*packed, level)) == image);
      };
      check({{0}, {255}}, 1, false);
      check({{0}, {85}, {170}, {255}}, 2, false);
      check({{0}, {17}, {34}, {238}}, 4, false);
      check({{9, 8, 7}, {1, 2, 3}}, 1, true);
      check({{9, 8, 7}, {1, 2, 3}, {5, 5, 5}}, 2, true);
      check({{9, 8, 7, 255}, {1, 2, 3, 0}, {5, 5, 5, 128}, {6, 6, 6, 3}, {7, 0, 0, 254}}, 4, true);
      std::vector<std::vector<std::uint8_t>> many;
      for (int i = 0; i < 256; ++i) many.push_back({static_cast<std::uint8_t>(i), 7, 200});
      check(many, 8, true);
    }
}

TEST_CASE("what no packed form holds with the same channels stays as it is") {
  CHECK(!packed_png(drawn(8, 8, {{0}, {1}})));
  // Readers would spread a palette over three or four channels.
  CHECK(!packed_png(drawn(8, 8, {{0, 255}, {255, 3}})));
  std::vector<std::vector<std::uint8_t>> many;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 3; ++j)
      many.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), 0});
  CHECK(!packed_png(drawn(64, 64, many)));
  // Without alphas in the file it would read as RGB.
  CHECK(!packed_png(drawn(8, 8, {{1, 2, 3, 255}, {4, 5, 6, 255}})));
}

TEST_CASE("the least file is never larger than the plain one, and is packed where that is smaller") {
  const Image8 mask = drawn(64, 64, {{0}, {255}});
  CHECK(least_png(mask, {}).size() < png_bytes(mask, {}).size());
  CHECK(read_by_others(least_png(mask, {})) == mask);
  // A ramp is nearly nothing as differences, but not as codes of a palette.
  Image8 ramp(256, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x) ramp.at(x, y)[0] = static_cast<std::uint8_t>(x + y);
  CHECK(packed_png(ramp));
  CHECK(least_png(ramp, {}).size() <= png_bytes(ramp, {}).size());
}

TEST_CASE("the level of a picture: what cannot be compressed is not tried hard, what can is") {
  Image8 noise(256, 256, 4);
  for (std::size_t i = 0; i < noise.values.size(); ++i)
    noise.values[i] = static_cast<std::uint8_t>(scrambled(static_cast<std::uint32_t>(i)));
  CHECK(png_level_for(noise) == PngLevel::fast);
  // A level that takes more time is taken only where it saves bytes.
  for (const std::uint32_t values : {2U, 5U, 40U}) {
    Image8 woven(256, 256, 4);
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x)
        for (std::uint32_t c = 0; c < 4; ++c)
          woven.at(x, y)[c] = static_cast<std::uint8_t>(
              scrambled(static_cast<std::uint32_t>(x % 61 + 61 * (y % 7)) * 4 + c) % values);
    const PngLevel level = png_level_for(woven);
    const auto size = [&](PngLevel at) { return png_bytes(woven, {at, 1}).size(); };
    CHECK((level == PngLevel::fast || size(level) < size(PngLevel::fast)));
  }
}
