// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/image/files/png.h"
#include "core/image/same_pictures.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("pictures of the same texels are one, whatever their bytes and wherever these lie") {
  Image8 image(40, 30, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<std::uint8_t>(i * i / 7);
  Image8 other = image;
  other.values.back() ^= 1;
  PngOptions smallest;
  smallest.level = PngLevel::smallest;
  const std::string bytes = png_bytes(image, {}), same_texels = png_bytes(image, smallest);
  REQUIRE(bytes != same_texels);
  const TempFolder folder;
  spit(folder.file("a.png"), bytes);
  spit(folder.file("b.png"), same_texels);
  spit(folder.file("c.png"), png_bytes(other, {}));
  spit(folder.file("broken.png"), bytes.substr(0, bytes.size() / 2));
  std::vector<PictureFile> pictures;
  for (const char* name : {"a.png", "c.png", "b.png", "broken.png", "b.png"})
    pictures.push_back({folder.file(name), "", name});
  pictures.push_back({"", same_texels, "inside"});
  pictures.push_back({"", "no picture", "text"});
  CHECK(first_of_same_pictures(pictures, std::vector<bool>(pictures.size(), true)) ==
        std::vector<int>{0, 1, 0, 3, 0, 0, 6});
  // What no material reads stands for itself.
  std::vector<bool> used(pictures.size(), true);
  used[0] = false;
  CHECK(first_of_same_pictures(pictures, used) == std::vector<int>{0, 1, 2, 3, 2, 2, 6});
}
