// SPDX-License-Identifier: Apache-2.0
#include "core/image/image_io.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "tests/support.h"

namespace etak {
namespace {

// A picture as an atlas has them: specular colour with gloss, and diffuse colour with opacity, also with
// colour where the fourth channel is 0.
Image8 two_textures() {
  Image8 out(16, 16, 4);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const auto p = out.at(x, y);
      p[0] = static_cast<std::uint8_t>(251 - x);
      p[1] = static_cast<std::uint8_t>(16 * y + x);
      p[2] = static_cast<std::uint8_t>(7 * x);
      p[3] = static_cast<std::uint8_t>(y < 4 ? 0 : 16 * y + 3);
    }
  return out;
}

bool leaves_only(const std::string& folder, const std::string& name) {
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename() != name) return false;
  return true;
}

}  // namespace

TEST_CASE("PNG: colour under opacity 0 and gloss in the fourth channel come back code for code") {
  const test::TempFolder folder;
  const std::string path = folder.file("t.png");
  const Image8 image = two_textures();
  write_png(path, image, false);
  CHECK(std::get<Image8>(read_picture(path).pixels) == image);
  CHECK(leaves_only(folder.path(), "t.png"));
  const Image values = read_image(path);
  for (std::size_t i = 0; i < image.values.size(); ++i) REQUIRE(to_code(values.values[i]) == image.values[i]);
}

TEST_CASE("OpenImageIO without oiio:UnassociatedAlpha destroys such a texture, both ways") {
  const test::TempFolder folder;
  const Image8 image = two_textures();
  const std::string good = folder.file("good.png"), bad = folder.file("bad.png");
  write_png(good, image, false);

  std::vector<unsigned char> read(image.values.size());
  const auto input = OIIO::ImageInput::open(good);
  REQUIRE(input);
  REQUIRE(input->read_image(0, 0, 0, 4, OIIO::TypeUInt8, read.data()));
  CHECK(read != image.values);
  CHECK(read[0] == 0);  // 251 under opacity 0

  const auto output = OIIO::ImageOutput::create(bad);
  REQUIRE(output);
  REQUIRE(output->open(bad, OIIO::ImageSpec(16, 16, 4, OIIO::TypeUInt8)));
  REQUIRE(output->write_image(OIIO::TypeUInt8, image.values.data()));
  REQUIRE(output->close());
  CHECK(std::get<Image8>(read_picture(bad).pixels) != image);
}

TEST_CASE("EXR: float comes back bit for bit, half to 11 bits, colour never times the fourth channel") {
  const test::TempFolder folder;
  Image image(5, 3, 4);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] =
        i % 4 == 3 ? (i % 8 == 3 ? 0.0f : 0.7f) : std::exp2(static_cast<float>(i) - 20) * 1.2345f;
  write_exr(folder.file("f.exr"), image, true, false);
  CHECK(read_image(folder.file("f.exr")) == image);
  image.values[0] = 1e9f;
  write_exr(folder.file("h.exr"), image, false, false);
  const Image half = read_image(folder.file("h.exr"));
  CHECK(half.values[0] == 65504);
  for (std::size_t i = 1; i < image.values.size(); ++i)
    if (image.values[i] < 65504 && image.values[i] > 1e-4f)
      CHECK(half.values[i] == Approx(image.values[i]).epsilon(1.0 / 2048));
  const PictureHeader info = read_picture_header(folder.file("h.exr"));
  CHECK((info.width == 5 && info.height == 3 && info.channels == 4 && info.bits == 16 && info.floating));
}

TEST_CASE("Radiance HDR is read as linear light") {
  const test::TempFolder folder;
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  for (const int value : {128, 64, 32, 129, 128, 128, 128, 136}) bytes += static_cast<char>(value);
  test::spit(folder.file("a.hdr"), bytes);
  const Image image = read_image(folder.file("a.hdr"));
  REQUIRE((image.width == 2 && image.height == 1 && image.channels == 3));
  CHECK(image.at(0, 0)[0] == Approx(1).epsilon(0.01));
  CHECK(image.at(0, 0)[2] == Approx(0.25).epsilon(0.02));
  CHECK(image.at(1, 0)[0] == Approx(128).epsilon(0.01));
}

TEST_CASE("errors name the file: missing, no picture, cut short, in the way, unwritable") {
  const test::TempFolder folder;
  const auto says = [](const std::string& text, const std::string& path, const char* part) {
    CHECK(test::contains(text, path));
    CHECK(test::contains(text, part));
  };
  const std::string missing = folder.file("missing.exr"), text = folder.file("text.png"),
                    cut = folder.file("cut.png");
  says(test::error_of([&] { (void)read_image(missing); }), missing, "No such file");
  says(test::error_of([&] { (void)read_image(folder.path()); }), folder.path(), "is a folder");
  test::spit(text, "no picture at all");
  says(test::error_of([&] { (void)read_image(text); }), text, "cannot be read as a picture");
  write_png(cut, two_textures(), false);
  const std::string whole = test::slurp(cut);
  test::spit(cut, whole.substr(0, whole.size() / 2));
  says(test::error_of([&] { (void)read_image(cut); }), cut, "");
  const std::string there = folder.file("there.png");
  write_png(there, two_textures(), false);
  says(test::error_of([&] { write_png(there, two_textures(), false); }), there, "exists already");
  CHECK_NOTHROW(write_png(there, two_textures(), true));
  const std::string nowhere = folder.file("no/such/folder.png");
  says(test::error_of([&] { write_png(nowhere, two_textures(), false); }), nowhere, "cannot be written");
}

TEST_CASE(
    "a size that the file cannot hold or etak does not read is refused before a decoder takes memory for it") {
  const auto why = [](const std::string& bytes, const char* name) {
    return test::error_of([&] { (void)read_picture(bytes, name); });
  };
  using namespace std::string_literals;
  CHECK(test::contains(why("GIF89a\xFF\x3F\xFF\x3F\0\0\0;"s, "a.gif"),
                       "states 16383 x 16383 pixels; expected no more than its 14 bytes can hold"));
  CHECK(
      test::contains(why("GIF89a\0\0\xFF\x3F\0\0\0;"s, "a.gif"), "is 0 x 16383 pixels; expected 1 to 16384"));
  CHECK(test::contains(why("RIFF\x16\0\0\0WEBPVP8X\x0A\0\0\0\0\0\0\0\xFF\xFF\xFF\x01\0\0"s, "a.webp"),
                       "is 16777216 x 2 pixels; expected 1 to 16384"));
  CHECK(test::contains(
      why("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x01\0\0\0\0\0\0\x80\x01\0\x08\0\x01\0\0\0"s, "a.bmp"),
      "is 1 x 2147483648 pixels; expected 1 to 16384"));
}

}  // namespace etak
