// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/base/hash/content_hash.h"
#include "core/image/channels.h"

using namespace etak;

TEST_CASE("ranges are those of a plain loop, for any number of texels") {
  std::mt19937 random(1);
  for (std::size_t count = 0; count < 70; ++count) {
    std::vector<std::uint8_t> texels(4 * count);
    for (auto& each : texels) each = static_cast<std::uint8_t>(100 + random() % 50);
    ChannelRange range;
    add_texels(range, Texture::specular_gloss, texels.data(), count);
    for (std::size_t c = 0; c < 4; ++c) {
      int least = 255, most = 0;
      for (std::size_t i = 0; i < count; ++i) {
        least = std::min<int>(least, texels[4 * i + c]);
        most = std::max<int>(most, texels[4 * i + c]);
      }
      CHECK(range.least[4 + c] == least);
      CHECK(range.most[4 + c] == most);
      CHECK(range.constant(c));  // no texel of the other texture was added
    }
  }
}

TEST_CASE("the content hash is XXH3 of 128 bits, whatever pieces the bytes come in") {
  const auto hash = [](const std::vector<std::string>& pieces) {
    ContentHash h;
    for (const std::string& each : pieces) h.add(each);
    return h.hex();
  };
  // As xxh128sum of xxHash 0.8 prints them.
  CHECK(hash({}) == "99aa06d3014798d86001c324468d497f");
  CHECK(hash({"abc"}) == "06b05ab6733a618578af5f94892f3950");
  CHECK(hash({"", "a", "", "bc"}) == hash({"abc"}));
  const std::string text(1000, 'x');
  for (const std::size_t cut : {1u, 31u, 240u, 255u, 999u})
    CHECK(hash({text.substr(0, cut), text.substr(cut)}) == hash({text}));
  ContentHash read_twice;
  read_twice.add("a");
  CHECK(read_twice.value() == read_twice.value());
  read_twice.add("bc");
  CHECK(read_twice.hex() == hash({"abc"}));
}

TEST_CASE("the content hash tells a changed bit, a swap and a cut apart") {
  std::string text(1000, 'a');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>('a' + i % 23);
  const auto hash = [](const std::string& t) {
    ContentHash h;
    h.add(t);
    return h.hex();
  };
  const std::string whole = hash(text);
  CHECK(whole.size() == 32);
  for (std::size_t i = 0; i < text.size(); i += 37) {
    std::string other = text;
    other[i] = static_cast<char>(other[i] ^ 1);
    CHECK(hash(other) != whole);
  }
  std::string swapped = text;
  std::swap_ranges(swapped.begin(), swapped.begin() + 32, swapped.begin() + 64);
  CHECK(hash(swapped) != whole);
  CHECK(hash(text.substr(0, 999)) != whole);
  CHECK(hash(std::string(31, '\0')) != hash(std::string(32, '\0')));
}

TEST_CASE("one coloured texel anywhere ends the grey, in F0 only") {
  for (const std::size_t count : {1u, 3u, 16u, 17u, 64u, 129u}) {
    std::vector<std::uint8_t> rgba;
    for (std::size_t i = 0; i < count; ++i) {
      const auto v = static_cast<std::uint8_t>(7 * i);
      rgba.insert(rgba.end(), {v, v, v, static_cast<std::uint8_t>(i)});
    }
    ChannelRange range;
    add_texels(range, Texture::specular_gloss, rgba.data(), count);
    CHECK(range.grey);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        rgba[4 * i + c] ^= 16;
        ChannelRange one;
        add_texels(one, Texture::specular_gloss, rgba.data(), count);
        CHECK_FALSE(one.grey);
        ChannelRange diffuse;
        add_texels(diffuse, Texture::diffuse_alpha, rgba.data(), count);
        CHECK(diffuse.grey);
        rgba[4 * i + c] ^= 16;
      }
  }
}
