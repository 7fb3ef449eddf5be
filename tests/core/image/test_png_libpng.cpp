// SPDX-License-Identifier: Apache-2.0
// Compares the PNG reader with libpng: both give equal pixels, and the reader refuses every file that libpng
// refuses.
#include <png.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "core/base/error.h"
#include "core/image/files/png.h"
#include "tests/core/image/png_maker.h"

namespace etak {
namespace {

struct Memory {
  const std::string* bytes;
  std::size_t at;
};

struct Raw {
  std::vector<std::uint8_t> values;
  bool warned = false;
};

// The rows as they are in the file, with 16-bit samples big-endian; nullopt for files that libpng refuses.
std::optional<Raw> libpng_read(const std::string& bytes) {
  Raw out;
  png_structp png = png_create_read_struct(
      PNG_LIBPNG_VER_STRING, &out, [](png_structp p, png_const_charp) { png_longjmp(p, 1); },
      [](png_structp p, png_const_charp) { static_cast<Raw*>(png_get_error_ptr(p))->warned = true; });
  png_infop info = png_create_info_struct(png);
  std::vector<png_bytep> rows;
  Memory memory{&bytes, 0};
  volatile bool good = false;
  // NOLINTNEXTLINE(cert-err52-cpp): libpng's way to report errors
  if (setjmp(png_jmpbuf(png)) == 0) {
    png_set_read_fn(png, &memory, [](png_structp p, png_bytep to, std::size_t size) {
      auto& from = *static_cast<Memory*>(png_get_io_ptr(p));
      if (size > from.bytes->size() - from.at) png_error(p, "ends");
      std::memcpy(to, from.bytes->data() + from.at, size);
      from.at += size;
    });
    png_read_info(png, info);
    const std::size_t row = png_get_rowbytes(png, info), height = png_get_image_height(png, info);
    out.values.resize(row * height);
    for (std::size_t y = 0; y < height; ++y) rows.push_back(&out.values[y * row]);
    png_read_image(png, rows.data());
    png_read_end(png, nullptr);
    good = true;
  }
  png_destroy_read_struct(&png, &info, nullptr);
  if (!good) return std::nullopt;
  return out;
}

enum class Answer { read, other_form, refused };

// The same by PngReader; `why` gets the reason where it refuses the file.
Answer our_read(const std::string& bytes, std::vector<std::uint8_t>& out, std::string& why) {
  try {
    auto reader = PngReader::open(bytes, "t.png");
    if (!reader) return Answer::other_form;
    const PictureHeader& info = reader->header();
    const auto row = static_cast<std::size_t>(info.width * info.channels * info.bits / 8);
    out.assign(row * static_cast<std::size_t>(info.height), 0);
    reader->read_rows(out.data(), row, info.height);
    if (info.bits == 16)
      for (std::size_t i = 0; i < out.size(); i += 2) {
        std::uint16_t value = 0;
        std::memcpy(&value, &out[i], 2);
        out[i] = static_cast<std::uint8_t>(value >> 8);
        out[i + 1] = static_cast<std::uint8_t>(value);
      }
    return Answer::read;
  } catch (const Error& error) {
    why = error.what();
    return Answer::refused;
  }
}

void agrees(const test::PngSpec& spec) {
  const std::string bytes = test::make_png(spec);
  CAPTURE(spec.width, spec.height, spec.colour, spec.bits, spec.filter, spec.idat, spec.level, spec.strategy,
          spec.window, spec.interlace);
  const auto expected = libpng_read(bytes);
  REQUIRE(expected);
  std::vector<std::uint8_t> pixels;
  std::string why;
  const Answer answer = our_read(bytes, pixels, why);
  CAPTURE(why);
  if (spec.bits >= 8 && spec.colour != 3 && spec.interlace == 0) {
    REQUIRE(answer == Answer::read);
    REQUIRE(pixels == expected->values);
  } else {
    REQUIRE(answer == Answer::other_form);
  }
}

constexpr std::pair<int, int> forms[] = {{0, 1}, {0, 2}, {0, 4}, {0, 8}, {0, 16}, {2, 8}, {2, 16}, {3, 1},
                                         {3, 2}, {3, 4}, {3, 8}, {4, 8}, {4, 16}, {6, 8}, {6, 16}};

std::string some_chunks() {
  return test::png_chunk("gAMA", test::big_endian(45455)) + test::png_chunk("sRGB", std::string(1, '\0')) +
         test::png_chunk("tEXt", std::string("Title\0x", 7)) + test::png_chunk("zzZz", "private") +
         test::png_chunk("pHYs", test::big_endian(2835) + test::big_endian(2835) + '\1');
}

}  // namespace

TEST_CASE("every form, size and filter reads as in libpng") {
  for (const auto& [colour, bits] : forms)
    for (int filter = -1; filter < 5; ++filter) {
      for (unsigned width = 1; width <= 40; ++width)
        agrees({width, 6, colour, bits, 0, filter, 6, 0, 15, 0, false, {}, {}, width});
      agrees({1, 1, colour, bits, 0, filter});
      agrees({1, 50, colour, bits, 0, filter});
      agrees({13, 11, colour, bits, 1, filter});
      agrees({1000, 70, colour, bits, 0, filter});
    }
}

TEST_CASE("every way to deflate the image data and to cut it into chunks reads as in libpng") {
  for (const auto& [colour, bits] : forms)
    for (const auto& [level, strategy] : {std::pair{0, Z_DEFAULT_STRATEGY},
                                          {1, Z_FIXED},
                                          {6, Z_FIXED},
                                          {9, Z_FILTERED},
                                          {1, Z_HUFFMAN_ONLY},
                                          {1, Z_RLE}})
      for (const std::size_t idat : {0, 1, 2, 3, 100, 8192})
        for (const bool empty : {false, true}) {
          test::PngSpec spec{41, 33, colour, bits};
          spec.level = level;
          spec.strategy = strategy;
          spec.idat = idat;
          spec.empty_idats = empty;
          spec.window = idat == 100 ? 9 : 15;
          spec.before = some_chunks();
          spec.behind = test::png_chunk("tEXt", std::string("Author\0y", 8));
          spec.seed = static_cast<unsigned>(idat + 1);
          agrees(spec);
        }
}

TEST_CASE(
    "what libpng refuses is refused, and what both read is equal, for damaged files with right checksums") {
  std::mt19937 engine(17);
  const auto random = [&] { return static_cast<unsigned>(engine()); };
  int read = 0, both_refuse = 0, ours_refuses = 0;
  for (int round = 0; round < 20000; ++round) {
    static constexpr std::pair<int, int> ours[] = {{0, 8}, {0, 16}, {2, 8}, {2, 16},
                                                   {4, 8}, {4, 16}, {6, 8}, {6, 16}};
    const auto& [colour, bits] = ours[random() % 8];
    test::PngSpec spec{1 + random() % 20, 1 + random() % 20, colour, bits};
    spec.seed = random();
    spec.strategy = random() % 4 == 0 ? Z_FIXED : Z_DEFAULT_STRATEGY;
    spec.level = random() % 5 == 0 ? 0 : 6;
    spec.idat = random() % 3 == 0 ? 1 + random() % 30 : 0;
    std::string stream = test::zlib_stream(test::png_filtered_rows(spec), spec.level, spec.strategy);
    // Damages the image data, or changes what the header says.
    switch (random() % 5) {
      case 0:
        stream[random() % stream.size()] ^= static_cast<char>(1 << random() % 8);
        break;
      case 1:
        stream[2 + random() % std::min<std::size_t>(stream.size() - 2, 60)] = static_cast<char>(random());
        break;
      case 2:
        stream.resize(random() % stream.size());
        break;
      case 3:
        stream.insert(random() % (stream.size() + 1), 1, static_cast<char>(random()));
        break;
      default:
        if (random() % 2 == 0)
          spec.height += random() % 3 - 1;
        else
          spec.width += random() % 3 - 1;
    }
    const std::string bytes = test::png_around(spec, stream);
    const auto expected = libpng_read(bytes);
    std::vector<std::uint8_t> pixels;
    std::string why;
    const Answer answer = our_read(bytes, pixels, why);
    CAPTURE(round, why);
    REQUIRE(answer != Answer::other_form);
    if (answer == Answer::read) {
      REQUIRE(expected);
      REQUIRE(pixels == expected->values);
      ++read;
    } else if (!expected) {
      ++both_refuse;
    } else {
      // Errors that png.h lists, for which libpng gives a warning or nothing at all.
      bool named = expected->warned;
      for (const char* reason : {"Adler-32", "incorrect data check", "goes on behind", "has no end"})
        named = named || why.find(reason) != std::string::npos;
      CHECK(named);
      ++ours_refuses;
    }
  }
  CAPTURE(read, both_refuse, ours_refuses);
  CHECK(read > 500);
  CHECK(both_refuse > 2000);
}

}  // namespace etak
