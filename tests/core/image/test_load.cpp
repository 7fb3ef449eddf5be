// SPDX-License-Identifier: Apache-2.0
#include "core/image/load.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/image/files/png.h"
#include "core/image/image_io.h"
#include "core/image/picture_bytes.h"
#include "tests/core/image/png_maker.h"
#include "tests/core/image/tiff_files.h"
#include "tests/support.h"

namespace etak {
namespace {

// Colours of about 200, with 0 in the last channel of most pixels: it stands for gloss as often as for
// opacity.
template <class Value>
Pixels<Value> gloss_in_last(int channels, Value scale) {
  Pixels<Value> out(9, 7, channels);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = static_cast<Value>(scale * static_cast<Value>(200 - i % 5));
  if (channels % 2 == 0)
    for (std::size_t i = 0; i < out.pixel_count(); ++i)
      out.values[(i + 1) * static_cast<std::size_t>(channels) - 1] =
          static_cast<Value>(i % 3 == 2 ? scale * 77 : 0);
  return out;
}

// Writes a picture by OpenImageIO itself, without core/image.
void write_by_oiio(const std::string& path, const Image8& image,
                   const std::vector<std::pair<std::string, std::string>>& attributes = {}) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeUInt8);
  spec["oiio:UnassociatedAlpha"] = 1;
  for (const auto& [name, value] : attributes) spec[name] = value;
  const auto output = OIIO::ImageOutput::create(path);
  REQUIRE(output);
  REQUIRE(output->open(path, spec));
  REQUIRE(output->write_image(OIIO::TypeUInt8, image.values.data()));
  REQUIRE(output->close());
}

// An uncompressed TIFF of one CMYK pixel, by hand (TIFF 6.0).
std::string cmyk_tiff() {
  const std::vector<std::vector<unsigned>> entries{{256, 3, 1, 1}, {257, 3, 1, 1}, {258, 3, 4, 122},
                                                   {259, 3, 1, 1}, {262, 3, 1, 5}, {273, 4, 1, 130},
                                                   {277, 3, 1, 4}, {278, 3, 1, 1}, {279, 4, 1, 4}};
  std::string out("II*\0\x08\0\0\0", 8);
  const auto add = [&](unsigned value, int bytes) {
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i);
  };
  add(static_cast<unsigned>(entries.size()), 2);
  for (const auto& entry : entries) {
    add(entry[0], 2);
    add(entry[1], 2);
    add(entry[2], 4);
    add(entry[3], 4);
  }
  add(0, 4);
  for (int i = 0; i < 4; ++i) add(8, 2);
  return out + "\x10\x20\x30\x40";
}

Picture loaded(const std::string& path) {
  return load_picture(path, picture_door());
}
Picture loaded(std::string_view bytes, const std::string& label) {
  return load_picture(bytes, label, picture_door());
}

std::string why(const std::string& path) {
  return test::error_of([&] { (void)loaded(path); });
}

}  // namespace

TEST_CASE("colour is never multiplied by the last channel: PNG, TIFF and EXR keep every code") {
  const test::TempFolder folder;
  for (int channels = 1; channels <= 4; ++channels) {
    CAPTURE(channels);
    const auto codes = gloss_in_last<std::uint8_t>(channels, 1);
    const auto wide = gloss_in_last<std::uint16_t>(channels, 257);
    const auto floats = gloss_in_last<float>(channels, 0.01f);
    const std::string name = folder.file(std::to_string(channels));
    write_png(name + ".png", codes, false);
    CHECK(std::get<Image8>(loaded(name + ".png").pixels) == codes);
    CHECK(std::get<Image8>(read_picture(name + ".png").pixels) == codes);
    test::write_tiff(name + "-8.tif", codes);
    CHECK(std::get<Image8>(loaded(name + "-8.tif").pixels) == codes);
    CHECK(std::get<Image8>(loaded(test::slurp(name + "-8.tif"), "bytes").pixels) == codes);
    test::write_tiff(name + "-16.tif", wide);
    CHECK(std::get<Image16>(loaded(name + "-16.tif").pixels) == wide);
    CHECK(std::get<Image16>(read_picture(name + "-16.tif").pixels) == wide);
    test::write_tiff(name + "-f.tif", floats);
    CHECK(std::get<Image>(loaded(name + "-f.tif").pixels) == floats);
    write_exr(name + ".exr", floats, true, false);
    CHECK(std::get<Image>(loaded(name + ".exr").pixels) == floats);
    CHECK(std::get<Image>(loaded(test::slurp(name + ".exr"), "bytes").pixels) == floats);
  }
  const std::string png16 = png_bytes(gloss_in_last<std::uint16_t>(4, 257), {});
  CHECK(std::get<Image16>(loaded(png16, "16").pixels) == gloss_in_last<std::uint16_t>(4, 257));
  test::spit(folder.file("16.png"), png16);
  CHECK(std::get<Image16>(read_picture(folder.file("16.png")).pixels) ==
        gloss_in_last<std::uint16_t>(4, 257));
}

TEST_CASE("NaN and infinity of float files stay for the caller to judge") {
  const test::TempFolder folder;
  Image image(3, 1, 3, 0.5f);
  image.values[1] = std::numeric_limits<float>::quiet_NaN();
  image.values[5] = std::numeric_limits<float>::infinity();
  write_exr(folder.file("f.exr"), image, true, false);
  test::write_tiff(folder.file("f.tif"), image);
  for (const char* name : {"f.exr", "f.tif"}) {
    const Picture loaded = load_picture(folder.file(name), picture_door());
    const auto& values = std::get<Image>(loaded.pixels).values;
    CHECK(std::isnan(values[1]));
    CHECK(std::isinf(values[5]));
    CHECK(values[0] == 0.5f);
    CHECK(loaded.header.bits == 32);
  }
}

TEST_CASE("the forms that the fast PNG reader leaves out are read all the same, palettes expanded") {
  const test::TempFolder folder;
  for (const auto& [spec, channels, bits] : {std::tuple{test::PngSpec{11, 7, 3, 8}, 3, 8},
                                             {test::PngSpec{11, 7, 3, 2}, 3, 8},
                                             {test::PngSpec{11, 7, 0, 1}, 1, 8},
                                             {test::PngSpec{11, 7, 6, 8, 1}, 4, 8},
                                             {test::PngSpec{11, 7, 2, 16, 1}, 3, 16}}) {
    const std::string bytes = test::make_png(spec);
    CHECK(!PngReader::open(bytes, ""));
    const Picture image = loaded(bytes, "buffer 3");
    CHECK((image.header.width == 11 && image.header.height == 7));
    CHECK(image.header.channels == channels);
    CHECK(image.header.bits == bits);
    CHECK(image.header.format == "png");
    CHECK(!image.header.lossy);
    // A file that is cut or changed at any byte is refused, as all damaged PNG files are.
    for (std::size_t size = 0; size < bytes.size(); size += 5)
      CHECK(!test::error_of([&] { (void)loaded(bytes.substr(0, size), "b"); }).empty());
  }
  test::PngSpec transparent{11, 7, 3, 8};
  transparent.before = test::png_chunk("tRNS", std::string(100, '\0'));
  CHECK(loaded(test::make_png(transparent), "b").header.channels == 4);
}

TEST_CASE("what a file says of its colours and its compression is reported") {
  const test::TempFolder folder;
  const Image8 image(16, 16, 3, 99);
  write_by_oiio(folder.file("a.jpg"), image);
  const Picture jpeg = loaded(folder.file("a.jpg"));
  CHECK(jpeg.header.lossy);
  CHECK(jpeg.header.format == "jpeg");
  CHECK(loaded(test::slurp(folder.file("a.jpg")), "buffer 0").pixels == jpeg.pixels);
  CHECK(is_lossy({"RIFF....WEBPVP8X\x0A\0\0\0..........VP8 ....", 42}, "webp", ""));
  CHECK(!is_lossy({"RIFF....WEBPVP8X\x0A\0\0\0..........VP8L....", 42}, "webp", ""));
  CHECK(is_lossy("", "openexr", "dwab"));
  CHECK(is_lossy("", "dds", "DXT5"));
  CHECK(!is_lossy("", "openexr", "zip"));

  test::PngSpec spec{4, 4};
  const auto declared = [&] { return loaded(test::make_png(spec), "p").header.colour_space; };
  CHECK(declared().empty());
  spec.before = test::png_chunk("gAMA", test::big_endian(45455));
  CHECK(declared() == "power-2.2");
  spec.before = test::png_chunk("sRGB", std::string(1, '\0')) + spec.before;
  CHECK(declared() == "srgb");
  spec.interlace = 1;
  CHECK(declared() == "srgb");
}

TEST_CASE("formats are known by their first bytes, whatever the name says") {
  const test::TempFolder folder;
  const Image8 image(5, 5, 3, 42);
  test::write_tiff(folder.file("a.tif"), image);
  test::spit(folder.file("really-tiff.png"), test::slurp(folder.file("a.tif")));
  CHECK(std::get<Image8>(loaded(folder.file("really-tiff.png")).pixels) == image);
  CHECK(std::get<Image8>(read_picture(folder.file("really-tiff.png")).pixels) == image);
  CHECK(picture_format("", "a.TGA") == "targa");
  CHECK(picture_format("\xFF\xD8\xFF", "a.png") == "jpeg");
  CHECK(picture_format("text", "a.png").empty());
}

TEST_CASE("what is no whole picture is refused in one line that names it") {
  const test::TempFolder folder;
  const auto refused = [&](const std::string& name, const std::string& bytes, const std::string& part) {
    const std::string path = folder.file(name);
    test::spit(path, bytes);
    for (const std::string& text : {why(path), test::error_of([&] { (void)loaded(bytes, path); })}) {
      CHECK_THAT(text, Catch::StartsWith(path + ": "));
      CHECK_THAT(text, Catch::Contains(part));
      CHECK(text.find('\n') == std::string::npos);
    }
  };
  refused("empty.png", "", "is empty");
  refused("text.png", "not a picture at all, but a text", "cannot be read as a picture");
  refused("cmyk.tif", cmyk_tiff(), "holds CMYK colours; expected grey or RGB");
  refused("wide.png", test::make_png({16385, 1, 0, 1}), "is 16385 x 1 pixels; expected 1 to 16384 on a side");
  refused("wide.ppm", "P5 16385 1 255\n" + std::string(16385, 'x'), "is 16385 x 1 pixels; expected");
  CHECK(test::contains(why(folder.file("missing.png")), "cannot be opened"));
  CHECK(test::contains(why(folder.path()), "is a folder"));
}

TEST_CASE("a file cut short is refused in every format") {
  const test::TempFolder folder;
  Image8 image(40, 30, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<std::uint8_t>(i * i / 7);
  write_png(folder.file("a.png"), image, false);
  test::write_tiff(folder.file("a.tif"), image);
  Image floats(40, 30, 3);
  for (std::size_t i = 0; i < floats.values.size(); ++i)
    floats.values[i] = static_cast<float>(image.values[i]);
  write_exr(folder.file("a.exr"), floats, true, false);
  for (const char* name : {"a.jpg", "a.bmp", "a.hdr", "a.webp"}) write_by_oiio(folder.file(name), image);
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg", "a.bmp", "a.hdr", "a.webp"}) {
    const std::string path = folder.file(name), whole = test::slurp(path);
    CAPTURE(path);
    REQUIRE(why(path).empty());
    for (std::size_t part = 1; part <= 20; ++part) {
      const std::string cut = whole.substr(0, whole.size() * part / 20 - 1);
      CAPTURE(cut.size(), whole.size());
      CHECK(!test::error_of([&] { (void)loaded(cut, path); }).empty());
      if (part % 5 != 0) continue;
      test::spit(path, cut);
      CHECK(!why(path).empty());
      CHECK(!test::error_of([&] { (void)read_image(path); }).empty());
    }
  }
}

}  // namespace etak
