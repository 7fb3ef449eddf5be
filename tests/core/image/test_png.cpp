// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png.h"

#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <random>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/image/files/deflate.h"
#include "core/image/files/png_filters.h"
#include "tests/core/image/png_maker.h"
#include "tests/core/image/png_of.h"
#include "tests/support.h"

namespace etak {
namespace {

// A picture that is smooth in some places, noise in others, and flat in the rest.
template <class Value>
Pixels<Value> picture(int width, int height, int channels, unsigned seed = 5) {
  Pixels<Value> out(width, height, channels);
  std::mt19937 random(seed);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        out.at(x, y)[static_cast<std::size_t>(c)] =
            static_cast<Value>(y % 7 == 0   ? random()
                               : y % 3 == 0 ? 200
                                            : static_cast<unsigned>(x * 3 + y * 5 + c * 40) + random() % 4);
  return out;
}

Image16 read_16(const std::string& bytes) {
  PngReader reader = PngReader::open(bytes, "t.png").value();
  REQUIRE(reader.header().bits == 16);
  Image16 out(reader.header().width, reader.header().height, reader.header().channels);
  reader.read_rows(reinterpret_cast<std::uint8_t*>(out.values.data()),
                   static_cast<std::size_t>(2 * out.width * out.channels), out.height);
  return out;
}

template <class Value>
void comes_back(const Pixels<Value>& image, PngLevel level = PngLevel::fast) {
  const std::string bytes = png_bytes(image, {level, 1, false});
  CAPTURE(image.width, image.height, image.channels, sizeof(Value));
  if constexpr (sizeof(Value) == 1) {
    REQUIRE(test::read_png8(bytes, "t.png") == image);
  } else {
    REQUIRE(read_16(bytes) == image);
    REQUIRE(test::read_png8(bytes, "t.png") == std::nullopt);
  }
}

std::string png_refusal(const std::string& bytes) {
  return test::error_of([&] { (void)test::read_png8(bytes, "t.png"); });
}

std::string with_chunk(const test::PngSpec& spec, std::string before, std::string behind = {}) {
  test::PngSpec changed = spec;
  changed.before = std::move(before);
  changed.behind = std::move(behind);
  return test::make_png(changed);
}

}  // namespace

TEST_CASE("every form and size comes back value for value") {
  for (int channels = 1; channels <= 4; ++channels) {
    for (int width = 1; width <= 40; ++width) {
      comes_back(picture<std::uint8_t>(width, 9, channels));
      comes_back(picture<std::uint16_t>(width, 9, channels));
    }
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {700, 500}}) {
      comes_back(picture<std::uint8_t>(width, height, channels));
      comes_back(picture<std::uint16_t>(width, height, channels));
    }
  }
  comes_back(picture<std::uint8_t>(333, 222, 4), PngLevel::small);
  comes_back(picture<std::uint16_t>(333, 222, 3), PngLevel::smallest);
  comes_back(picture<std::uint8_t>(max_image_side, 2, 4));
  comes_back(picture<std::uint16_t>(2, max_image_side, 1));
}

TEST_CASE("colour under 0 in the fourth channel stays as it is") {
  Image8 image(20, 20, 4, 200);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) image.at(x, y)[3] = static_cast<std::uint8_t>(x < 10 ? 0 : y);
  comes_back(image);
}

TEST_CASE("the bytes are the same for any number of threads, and come in order") {
  const Image8 image = picture<std::uint8_t>(700, 1500, 4);
  const std::string one = png_bytes(image, {PngLevel::fast, 1});
  CHECK(test::read_png8(one, "t.png") == image);
  for (unsigned threads = 2; threads <= 9; ++threads)
    REQUIRE(png_bytes(image, {PngLevel::fast, threads}) == one);
  const std::string small = png_bytes(image, {PngLevel::small, 1});
  CHECK(test::read_png8(small, "t.png") == image);
  CHECK(png_bytes(image, {PngLevel::small, 3}) == small);
  CHECK(small.size() <= one.size());
}

TEST_CASE("a deflater's address is not in its bytes") {
  // Rows that are half noise and half zeros, where a wrong hash of the third byte changes the output most
  // often.
  std::mt19937 random(3);
  std::vector<std::uint8_t> strip(16385 * 31);
  std::vector<Deflater> deflaters;
  for (int i = 0; i < 48; ++i) deflaters.emplace_back(PngLevel::fast);
  for (int k = 0; k < 40; ++k) {
    for (std::size_t i = 0; i < strip.size(); ++i)
      strip[i] = i % 16385 < 10401 ? static_cast<std::uint8_t>(random()) : std::uint8_t{0};
    std::vector<std::uint8_t> first;
    for (Deflater& each : deflaters) {
      std::vector<std::uint8_t> bytes;
      each.append(strip, k % 2 == 0, bytes);
      if (first.empty()) first = bytes;
      REQUIRE((bytes == first));
    }
  }
}

TEST_CASE("rows in bands of any heights become the bytes of the whole picture") {
  const auto image = picture<std::uint8_t>(333, 700, 4);
  const auto wide = picture<std::uint16_t>(1025, 203, 3);
  for (const PngRows& rows : {PngRows(image), PngRows(wide)})
    for (const std::vector<int>& heights : {std::vector<int>{1, 7, 300, 2}, {393}, {64, 64, 64}, {0, 2, 0}}) {
      const PngOptions options;
      std::string out;
      PngBands bands(
          rows.header, options, [&](std::string_view piece) { out += piece; }, PngBands::scratch());
      int done = 0;
      std::vector<std::uint8_t> band;
      const auto next = [&](int height) {
        // Each band is in memory of its own, and the memory of the band before is overwritten.
        std::vector<std::uint8_t> fresh(rows.rows + static_cast<std::size_t>(done) * rows.stride,
                                        rows.rows + static_cast<std::size_t>(done + height) * rows.stride);
        const std::size_t strips = bands.next(fresh.data(), rows.stride, height);
        std::fill(band.begin(), band.end(), std::uint8_t{0xA5});
        for (std::size_t i = strips; i-- > 0;) bands.make(i);
        band.swap(fresh);
        done += height;
      };
      for (const int height : heights)
        if (done + height < rows.header.height) next(height);
      next(rows.header.height - done);
      bands.finish();
      const bool same = out == png_bytes(rows, options);
      CHECK(same);
    }
}

TEST_CASE("what the sink throws comes out for any number of threads") {
  const Image8 image = picture<std::uint8_t>(700, 1500, 4);
  for (unsigned threads = 1; threads <= 4; ++threads)
    for (int pieces = 0; pieces < 8; pieces += 3) {
      int left = pieces;
      CHECK_THROWS_AS(write_png(image, {PngLevel::fast, threads},
                                [&](std::string_view) {
                                  if (left-- == 0) throw std::runtime_error("full");
                                }),
                      std::runtime_error);
    }
}

namespace {

// Each view of it overwrites the bytes that the view before has given.
class ForgetfulBytes : public ByteSource {
 public:
  explicit ForgetfulBytes(std::string bytes) : bytes_(std::move(bytes)) {}
  std::size_t size() const override { return bytes_.size(); }
  std::string_view view(std::size_t at, std::size_t count) override {
    REQUIRE(at + count <= bytes_.size());
    before_ = std::move(now_);
    std::fill(before_.begin(), before_.end(), '\xA5');
    return now_ = bytes_.substr(at, count);
  }

 private:
  std::string bytes_, before_, now_;
};

}  // namespace

TEST_CASE("a file is read as rows are asked for, whatever the size of its chunks") {
  const Image8 image = picture<std::uint8_t>(301, 267, 4);
  const std::string bytes = png_bytes(image, {});
  std::string data;
  for (std::size_t at = 33; at + 12 < bytes.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    if (bytes.substr(at + 4, 4) == "IDAT") data += bytes.substr(at + 8, size);
    at += 12 + size;
  }
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{8192}, data.size()}) {
    // A long chunk before the image data is read in pieces too.
    std::string file = bytes.substr(0, 33) + test::png_chunk("teSt", std::string(200000, 'x'));
    for (std::size_t at = 0; at < data.size(); at += piece)
      file += test::png_chunk("IDAT", data.substr(at, piece));
    ForgetfulBytes source(file + test::png_chunk("IEND", ""));
    auto reader = PngReader::open(source, "t.png");
    REQUIRE(reader);
    std::vector<std::uint8_t> out(image.values.size());
    reader->read_rows(out.data(), 301 * 4, 267);
    CHECK(out == image.values);
  }
}

TEST_CASE("rows can be read a few at a time, and nothing beside them is written") {
  const Image8 image = picture<std::uint8_t>(101, 67, 3);
  const std::string bytes = png_bytes(image, {});
  for (const int step : {1, 2, 5, 66, 67}) {
    auto reader = PngReader::open(bytes, "t.png");
    REQUIRE(reader);
    PictureHeader expected{101, 67, 3, 8};
    expected.strips = true;
    expected.format = "png";
    CHECK(reader->header() == expected);
    const std::size_t stride = 303 + 9;
    std::vector<std::uint8_t> out(stride * 67, 77);
    for (int y = 0; y < 67; y += step) {
      const int count = std::min(step, 67 - y);
      std::vector<std::uint8_t> strip(stride * static_cast<std::size_t>(count), 77);
      reader->read_rows(strip.data(), stride, count);
      std::copy(strip.begin(), strip.end(), out.begin() + static_cast<std::ptrdiff_t>(stride) * y);
    }
    for (std::size_t y = 0; y < 67; ++y) {
      REQUIRE(std::memcmp(&out[y * stride], &image.values[y * 303], 303) == 0);
      for (std::size_t i = 303; i < stride; ++i) REQUIRE(out[y * stride + i] == 77);
    }
  }
}

TEST_CASE("all kinds of instructions filter and unfilter to the same bytes") {
  std::vector<const PngFilters*> kinds{&png_filters_portable()};
#ifdef ETAK_PNG_X86_64
  kinds.push_back(&png_filters_sse2());
  if (__builtin_cpu_supports("avx2")) kinds.push_back(&png_filters_avx2());
#endif
  std::mt19937 random(11);
  const std::array<std::uint8_t, 8> extremes{0, 1, 2, 127, 128, 129, 254, 255};
  for (const std::size_t pixel : {1, 2, 3, 4, 6, 8})
    for (std::size_t round = 0; round < 400; ++round) {
      const std::size_t size = pixel * (round < 80 ? round + 1 : 1000 + round);
      std::vector<std::uint8_t> row(png_row_lead + size + png_row_slack), above(row.size());
      for (std::size_t i = png_row_lead; i < row.size(); ++i) {
        const auto draw = [&]() {
          return round % 2 == 0 ? extremes[random() % 8] : static_cast<std::uint8_t>(random());
        };
        // In some rounds the byte is near the one to the left or above, so that each filter is the best one
        // somewhere.
        above[i] = draw();
        row[i] = round % 5 == 1   ? static_cast<std::uint8_t>(row[i - pixel] + random() % 3)
                 : round % 5 == 2 ? static_cast<std::uint8_t>(above[i] + random() % 3)
                 : round % 5 == 3 ? static_cast<std::uint8_t>((row[i - pixel] + above[i]) / 2 + random() % 3)
                                  : draw();
      }
      std::vector<std::uint8_t> expected;
      for (const PngFilters* kind : kinds) {
        CAPTURE(kind->instructions, pixel, size);
        std::vector<std::uint8_t> out(size + 1 + png_row_slack);
        kind->filter(row.data() + png_row_lead, above.data() + png_row_lead, size, pixel, out.data());
        std::vector<std::uint8_t> back(size + 1, 99);
        kind->unfilter(out[0], out.data() + 1, above.data() + png_row_lead, size, pixel, back.data());
        REQUIRE(std::memcmp(back.data(), row.data() + png_row_lead, size) == 0);
        REQUIRE(back[size] == 99);
        out.resize(size + 1);
        if (expected.empty()) expected = out;
        REQUIRE(out == expected);
      }
      for (int filter = 0; filter < 5; ++filter) {
        std::vector<std::uint8_t> one(size), other(size);
        kinds[0]->unfilter(filter, row.data() + png_row_lead, above.data() + png_row_lead, size, pixel,
                           one.data());
        for (const PngFilters* kind : kinds) {
          CAPTURE(kind->instructions, filter, pixel, size);
          kind->unfilter(filter, row.data() + png_row_lead, above.data() + png_row_lead, size, pixel,
                         other.data());
          REQUIRE(other == one);
        }
      }
    }
}

TEST_CASE("checksums are those of the standards") {
  const auto bytes = [](std::string_view text) {
    return std::vector<std::uint8_t>(text.begin(), text.end());
  };
  CHECK(crc32_of(0, bytes("123456789")) == 0xCBF43926);
  CHECK(crc32_of(crc32_of(0, bytes("1234")), bytes("56789")) == 0xCBF43926);
  CHECK(adler32_of(1, bytes("Wikipedia")) == 0x11E60398);
  CHECK(adler32_of(adler32_of(1, bytes("Wiki")), bytes("pedia")) == 0x11E60398);
  CHECK(adler32_of_both(adler32_of(1, bytes("Wiki")), adler32_of(1, bytes("pedia")), 5) == 0x11E60398);
  CHECK(adler32_of(1, {}) == 1);
}

TEST_CASE("the inflater gives all output however its input and output are cut, and no more") {
  // With long matches, the inflater still holds back much output when the input is used up.
  std::string text(300000, 'x');
  for (std::size_t i = 0; i < text.size(); i += 9000) text[i] = static_cast<char>(i / 9000);
  const std::string stream = test::zlib_stream(text) + "tail";
  for (const std::size_t feed : {1, 2, 7, 1000, 1000000})
    for (const std::size_t room : {1, 100, 65536, 1000000}) {
      if (room == 1 && feed > 7) continue;
      Inflater inflater;
      std::string out;
      std::size_t fed = 0;
      std::vector<std::uint8_t> buffer(room);
      for (Inflater::Status status{}; status != Inflater::Status::ended;) {
        std::size_t written = 0;
        status = inflater.read(buffer, written);
        out.append(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(written));
        REQUIRE(status != Inflater::Status::damaged);
        if (status != Inflater::Status::hungry) continue;
        REQUIRE(fed < stream.size());
        const std::size_t size = std::min(feed, stream.size() - fed);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): characters as bytes
        inflater.feed({reinterpret_cast<const std::uint8_t*>(stream.data()) + fed, size});
        fed += size;
      }
      CHECK(out == text);
      CHECK(fed - inflater.unused() == stream.size() - 4);
    }
}

TEST_CASE("what a file says of its colours is found in any form") {
  const test::PngSpec spec{3, 2};
  const auto declared = [](const std::string& bytes) {
    BytesInMemory file(bytes);
    return png_header(file).value().colour_space;
  };
  CHECK(declared(test::make_png(spec)).empty());
  const std::string gamma = test::png_chunk("gAMA", test::big_endian(45455));
  CHECK(declared(with_chunk(spec, gamma)) == "power-2.2");
  CHECK(declared(with_chunk(spec, test::png_chunk("gAMA", test::big_endian(100000)))) == "linear");
  CHECK(declared(with_chunk(spec, test::png_chunk("gAMA", test::big_endian(60000)))) == "gamma 0.6");
  CHECK(declared(with_chunk(spec, gamma + test::png_chunk("iCCP", std::string("x\0\0y", 4)))) == "icc: x");
  CHECK(declared(with_chunk(spec, gamma + test::png_chunk("sRGB", "x"))) == "srgb");
  CHECK(declared(with_chunk({3, 2, 3, 4}, test::png_chunk("sRGB", "x"))) == "srgb");
  BytesInMemory other("no picture");
  CHECK(!png_header(other));
  const Image8 image(2, 2, 3, 9);
  const std::string bytes = png_bytes(image, {PngLevel::fast, 1, true});
  CHECK(declared(bytes) == "srgb");
  CHECK(test::read_png8(bytes, "t.png") == image);
}

TEST_CASE("forms that are not read here are left to others") {
  for (const std::string& bytes :
       {std::string(), std::string("\xFF\xD8\xFF\xE0 a JPEG"), test::make_png({5, 4, 3, 8}),
        test::make_png({5, 4, 3, 1}), test::make_png({5, 4, 0, 4}), test::make_png({5, 4, 6, 8, 1}),
        with_chunk({5, 4, 2, 8}, test::png_chunk("tRNS", std::string(6, '\0')))}) {
    CHECK(!PngReader::open(bytes, "t.png"));
    CHECK(!test::read_png8(bytes, "t.png"));
  }
}

TEST_CASE("broken files are refused with the place and the reason") {
  const test::PngSpec spec{7, 5};
  const std::string stream = test::zlib_stream(test::png_filtered_rows(spec)), whole = test::make_png(spec);
  CHECK(png_refusal(whole).empty());
  const auto says = [](const std::string& bytes, const std::string& part) {
    CHECK_THAT(png_refusal(bytes), Catch::StartsWith("t.png: "));
    CHECK_THAT(png_refusal(bytes), Catch::Contains(part));
  };
  says(std::string(png_signature) + whole.substr(8 + 25), "IDAT at byte 8 comes first, where IHDR belongs");
  says(test::make_png({0, 5}), "is 0 x 5 pixels; expected 1 to 16384 on a side");
  says(test::make_png({16385, 1}), "is 16385 x 1 pixels");
  says(test::make_png({7, 5, 5, 8}), "colour type 5");
  says(test::make_png({7, 5, 6, 4}), "bit depth 4, colour type 6");
  says(test::png_around({16384, 16384, 6, 16}, stream), "too few for its 16384 x 16384 pixels");
  says(with_chunk(spec, test::png_chunk("CRIT", "")), "CRIT at byte 33");
  says(with_chunk(spec, test::png_chunk("IHDR", std::string(13, '\1'))), "IHDR at byte 33");
  says(with_chunk(spec, test::png_chunk("a1cd", "")), "has no valid type");
  says(with_chunk(spec, {}, test::png_chunk("tEXt", "a") + test::png_chunk("IDAT", "")),
       "has no place behind");
  says(with_chunk({7, 5, 0, 8}, test::png_chunk("PLTE", "abc")), "is no palette that belongs here");
  says(with_chunk({7, 5, 2, 8}, test::png_chunk("PLTE", "abcd")), "is no palette that belongs here");
  says(test::png_around({7, 6}, stream), "image data ends before the last of its 6 rows");
  says(test::png_around({7, 4}, stream), "image data goes on behind the last of its 4 rows");
  says(test::png_around(spec, stream + "x"), "image data goes on behind its end");
  says(test::png_around(spec, stream.substr(0, stream.size() - 1)), "image data has no end");
  says(test::png_around(spec, stream.substr(0, stream.size() / 2)), "image data is cut short");
  says(whole.substr(0, whole.size() - 12), "ends at byte");
  std::string other = stream;
  other.back() = static_cast<char>(other.back() + 1);
  says(test::png_around(spec, other), "image data is damaged");
  std::string rows = test::png_filtered_rows(spec);
  rows[0] = 5;
  says(test::png_around(spec, test::zlib_stream(rows)), "row 0 has filter 5; expected 0 to 4");
  says(std::string(png_signature) + test::png_header(spec) + test::png_chunk("IEND", ""), "IEND at byte 33");
  const std::string closed = whole.substr(0, whole.size() - 12) + test::png_chunk("IEND", "x");
  says(closed, "is not empty");
  std::string text = with_chunk(spec, test::png_chunk("tEXt", "Comment"));
  text[33 + 10] = 'X';
  says(text, "tEXt at byte 33 has a wrong checksum");
  CHECK(png_refusal(whole + "trailing bytes").empty());
}

TEST_CASE("a window said to be smaller than the stream needs does no harm") {
  const test::PngSpec spec{200, 50};
  std::string stream = test::zlib_stream(test::png_filtered_rows(spec));
  const auto expected = test::read_png8(test::png_around(spec, stream), "t.png");
  REQUIRE(expected);
  for (int window = 8; window < 15; ++window) {
    const int header = (window - 8) << 12 | 0x800;
    stream[0] = static_cast<char>(header >> 8);
    stream[1] = static_cast<char>(31 - header % 31);
    CHECK(test::read_png8(test::png_around(spec, stream), "t.png") == expected);
  }
  const int header = 8 << 12 | 0x800;
  stream[0] = static_cast<char>(header >> 8);
  stream[1] = static_cast<char>(31 - header % 31);
  CHECK_THAT(png_refusal(test::png_around(spec, stream)), Catch::Contains("image data is damaged"));
}

TEST_CASE("a file cut anywhere and a file with any bit flipped is refused") {
  for (const std::size_t idat : {0, 10}) {
    test::PngSpec spec{6, 4, 6, 8};
    spec.idat = idat;
    spec.before = test::png_chunk("gAMA", test::big_endian(45455));
    const std::string whole = test::make_png(spec);
    REQUIRE(test::read_png8(whole, "t.png"));
    const auto read = [](const std::string& bytes) {
      try {
        return test::read_png8(bytes, "t.png").has_value();
      } catch (const Error&) {
        return false;
      }
    };
    for (std::size_t size = 0; size < whole.size(); ++size) REQUIRE(!read(whole.substr(0, size)));
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      std::string flipped = whole;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
      CAPTURE(bit);
      REQUIRE(!read(flipped));
    }
  }
}

}  // namespace etak
