// SPDX-License-Identifier: Apache-2.0
#include "core/image/load.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/error.h"
#include "tests/core/image/png_of.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A picture that hardly compresses, so that its file is about as large as its pixels.
Image8 noise(int side) {
  Image8 out(side, side, 4);
  std::uint32_t state = 1;
  for (std::uint8_t& value : out.values) {
    state = state * 1664525u + 1013904223u;
    value = static_cast<std::uint8_t>(state >> 24);
  }
  return out;
}

}  // namespace

TEST_CASE("rows of a PNG that is read piece by piece are those of the picture, and its header is told") {
  const TempFolder folder;
  const std::string path = folder.file("a.png");
  const Image8 image = noise(700);
  spit(path, png_of(image));
  const auto rows = open_rows(path);
  REQUIRE(rows);
  CHECK(rows->header().width == 700);
  CHECK(rows->header().format == "png");
  Image8 read(700, 700, 4);
  for (int y = 0; y < 700; y += 70)
    rows->read_rows(&read.values[static_cast<std::size_t>(y) * 2800], 2800, 70);
  CHECK(read.values == image.values);
}

TEST_CASE("a picture that shrinks between two rows is an error that says so, not a SIGBUS") {
  const TempFolder folder;
  const std::string path = folder.file("a.png");
  const std::string bytes = png_of(noise(1300));  // above 4 MiB
  REQUIRE(bytes.size() > std::size_t{5} << 20);
  std::vector<std::uint8_t> row(std::size_t{1300} * 4);
  for (const std::size_t left : {std::size_t{0}, std::size_t{8}, std::size_t{300000}, bytes.size() - 1}) {
    spit(path, bytes);
    const auto rows = open_picture(path, {});
    rows->read_rows(row.data(), row.size(), 1);
    std::filesystem::resize_file(path, left);
    const std::string message = error_of([&] {
      for (int y = 1; y < 1300; ++y) rows->read_rows(row.data(), row.size(), 1);
    });
    CHECK(message == path + ": changed while it was read, found " + std::to_string(left) +
                         " bytes; expected " + std::to_string(bytes.size()) + " bytes");
  }
}

TEST_CASE("a picture that is written anew while it is read is told from a damaged one") {
  const TempFolder folder;
  const std::string path = folder.file("a.png");
  const std::string bytes = png_of(noise(1300));
  std::string other = bytes;
  for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 100; ++i) other[i] = '\0';
  const auto read_all = [&](bool change) {
    spit(path, bytes);
    std::filesystem::last_write_time(path, {});
    const auto rows = open_picture(path, {});
    if (change) spit(path, other);
    std::vector<std::uint8_t> row(std::size_t{1300} * 4);
    return error_of([&] {
      for (int y = 0; y < 1300; ++y) rows->read_rows(row.data(), row.size(), 1);
    });
  };
  CHECK(read_all(false).empty());
  CHECK(read_all(true) == path + ": changed while it was read; expected a file that stays as it is");
}
