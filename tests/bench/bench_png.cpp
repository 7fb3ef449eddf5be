// SPDX-License-Identifier: Apache-2.0
// Time and size of PNG reading and writing beside libpng's, in one run:
//   bench_png COLOUR.png [GREY.png] [ROUNDS]
// With two files the first's RGB and the second's grey become one RGBA picture, as in an atlas. Rounds are
// interleaved and the median is printed, in MB of pixels per second. Every result is compared with the pixels
// before it is timed.
#include <png.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/image/files/png.h"
#include "tests/core/image/png_of.h"

using namespace etak;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Memory {
  std::string_view bytes;
  std::size_t at = 0;
};

Image8 libpng_read(std::string_view bytes) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  Memory memory{bytes};
  png_set_read_fn(png, &memory, [](png_structp p, png_bytep out, std::size_t size) {
    auto& from = *static_cast<Memory*>(png_get_io_ptr(p));
    std::memcpy(out, from.bytes.data() + from.at, size);
    from.at += size;
  });
  png_read_info(png, info);
  Image8 out(static_cast<int>(png_get_image_width(png, info)),
             static_cast<int>(png_get_image_height(png, info)), png_get_channels(png, info));
  for (int y = 0; y < out.height; ++y) png_read_row(png, out.at(0, y).data(), nullptr);
  png_read_end(png, nullptr);
  png_destroy_read_struct(&png, &info, nullptr);
  return out;
}

std::string libpng_write(const Image8& image, int level) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp p, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), size);
      },
      nullptr);
  png_set_compression_level(png, level);
  static constexpr int type[] = {0, 0, 4, 2, 6};
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               type[image.channels], 0, 0, 0);
  png_write_info(png, info);
  Image8 copy = image;
  for (int y = 0; y < image.height; ++y) png_write_row(png, copy.at(0, y).data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

Image8 read(std::string_view bytes) {
  auto image = test::read_png8(bytes, "picture");
  if (!image) throw Error("only 8-bit grey, grey + alpha, RGB and RGBA");
  return std::move(*image);
}

struct Case {
  std::string name;
  std::function<std::size_t()> run;  // returns bytes of the file
  std::vector<double> seconds = {};
  std::size_t bytes = 0;
};

void measure(std::vector<Case>& cases, int rounds, double megabytes) {
  for (int i = 0; i < rounds; ++i)
    for (Case& c : cases) {
      const double start = now();
      c.bytes = c.run();
      c.seconds.push_back(now() - start);
    }
  for (Case& c : cases) {
    std::sort(c.seconds.begin(), c.seconds.end());
    const double median = c.seconds[c.seconds.size() / 2];
    std::printf("%-28s %8.4f s %8.0f MB/s (best %5.0f) %9zu bytes, ratio %.3f\n", c.name.c_str(), median,
                megabytes / median, megabytes / c.seconds.front(), c.bytes,
                megabytes * 1e6 / static_cast<double>(c.bytes));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::puts("bench_png COLOUR.png [GREY.png] [ROUNDS]");
    return 1;
  }
  const auto is_number = [](const char* text) {
    return std::strspn(text, "0123456789") == std::strlen(text);
  };
  const std::string file = read_file(argv[1], std::size_t{1} << 31);
  Image8 image = libpng_read(file);
  if (argc > 2 && !is_number(argv[2])) {
    const Image8 grey = libpng_read(read_file(argv[2], std::size_t{1} << 31));
    Image8 both(image.width, image.height, 4);
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
      std::copy_n(&image.values[3 * i], 3, &both.values[4 * i]);
      both.values[4 * i + 3] = grey.values[i];
    }
    image = both;
  }
  const int rounds = is_number(argv[argc - 1]) ? std::atoi(argv[argc - 1]) : 5;
  const double megabytes = static_cast<double>(image.values.size()) / 1e6;
  const std::size_t stride = static_cast<std::size_t>(image.width * image.channels);
  const PngRows rows{{image.width, image.height, image.channels, 8}, image.values.data(), stride};

  std::vector<Case> writes;
  const auto ours = [&](const char* name, PngLevel level, unsigned threads) {
    if (read(png_bytes(rows, {level, threads})) != image ||
        libpng_read(png_bytes(rows, {level, threads})) != image)
      throw Error("a picture written by us comes back changed");
    writes.push_back(
        {name, [=, &rows] {
           std::size_t size = 0;
           write_png(rows, {level, threads}, [&](std::string_view piece) { size += piece.size(); });
           return size;
         }});
  };
  ours("write fast", PngLevel::fast, 1);
  ours("write fast, 2 threads", PngLevel::fast, 2);
  writes.push_back({"libpng, level 1", [&] { return libpng_write(image, 1).size(); }});
  if (std::getenv("SLOW") != nullptr) {
    ours("write small", PngLevel::small, 1);
    writes.push_back({"libpng, level 6", [&] { return libpng_write(image, 6).size(); }});
    ours("write smallest", PngLevel::smallest, 1);
    writes.push_back({"libpng, level 9", [&] { return libpng_write(image, 9).size(); }});
  }
  measure(writes, rounds, megabytes);

  const std::string deflated6 = argc > 2 && !is_number(argv[2]) ? libpng_write(image, 6) : file,
                    fast = png_bytes(rows, {});
  Image8 reused = image;
  std::vector<Case> reads;
  for (const auto& [name, bytes] : {std::pair{"zlib-6 file", &deflated6}, {"our fast file", &fast}}) {
    if (read(*bytes) != image) throw Error("read picture differs");
    reads.push_back({std::string("read ") + name, [&, b = bytes] {
                       PngReader::open(*b, "")->read_rows(reused.values.data(), stride, image.height);
                       return b->size();
                     }});
    reads.push_back({std::string("libpng ") + name, [b = bytes] {
                       const Image8 out = libpng_read(*b);
                       return b->size();
                     }});
  }
  measure(reads, rounds, megabytes);
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "bench_png: %s\n", e.what());
  return 1;
}
