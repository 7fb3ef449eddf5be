// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/files/png_chunks.h"

/// Makes PNG files of every form byte by byte, for tests. Nothing of core/image is used, so that the tests
/// are independent of it.
namespace etak::test {

inline std::string big_endian(std::uint32_t value) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift);
  return out;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
  const auto crc = ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body +
         big_endian(static_cast<std::uint32_t>(crc));
}

struct PngSpec {
  unsigned width = 1, height = 1;
  int colour = 6, bits = 8, interlace = 0;
  int filter = -1;                       // of every row; -1: the filters take turns
  int level = 6;                         // of zlib; 0: stored blocks
  int strategy = 0;                      // of zlib; Z_FIXED: fixed Huffman codes
  int window = 15;                       // log2
  std::size_t idat = 0;                  // bytes in an IDAT chunk; 0: all in one chunk
  bool empty_idats = false;              // an empty IDAT before each one and one at the end
  std::string before = {}, behind = {};  // chunks around the image data
  unsigned seed = 1;
};

inline unsigned png_channels(int colour) {
  return colour == 2 ? 3 : colour == 4 ? 2 : colour == 6 ? 4 : 1;
}

/// The zlib stream of random but compressible rows. The filtered bytes are random, so that the filters meet
/// every value; which pixels these bytes stand for is left to the decoders.
inline std::string png_filtered_rows(const PngSpec& spec) {
  std::mt19937 random(spec.seed);
  std::string rows;
  const auto pass = [&](unsigned width, unsigned height) {
    if (width == 0 || height == 0) return;
    const std::size_t bytes =
        (std::size_t{width} * png_channels(spec.colour) * static_cast<unsigned>(spec.bits) + 7) / 8;
    for (unsigned y = 0; y < height; ++y) {
      rows += static_cast<char>(spec.filter >= 0 ? static_cast<unsigned>(spec.filter) : (y + spec.seed) % 5);
      for (std::size_t i = 0; i < bytes; ++i)
        // A palette of 256 entries and pictures of fewer bits allow any byte.
        rows +=
            random() % 3 != 0 && i > 0 ? rows[rows.size() - 1 - random() % i] : static_cast<char>(random());
    }
  };
  if (spec.interlace == 0) {
    pass(spec.width, spec.height);
  } else {
    static constexpr unsigned start[7][2] = {{0, 0}, {4, 0}, {0, 4}, {2, 0}, {0, 2}, {1, 0}, {0, 1}};
    static constexpr unsigned step[7][2] = {{8, 8}, {8, 8}, {4, 8}, {4, 4}, {2, 4}, {2, 2}, {1, 2}};
    for (int p = 0; p < 7; ++p)
      pass((spec.width + step[p][0] - 1 - start[p][0]) / step[p][0],
           (spec.height + step[p][1] - 1 - start[p][1]) / step[p][1]);
  }
  return rows;
}

inline std::string zlib_stream(const std::string& bytes, int level = 6, int strategy = 0, int window = 15) {
  z_stream z{};
  if (::deflateInit2(&z, level, Z_DEFLATED, window, 8, strategy) != Z_OK) std::abort();
  std::string out(::deflateBound(&z, static_cast<uLong>(bytes.size())) + 100, '\0');
  std::string in = bytes;
  // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast)
  z.next_in = reinterpret_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  z.avail_out = static_cast<uInt>(out.size());
  if (::deflate(&z, Z_FINISH) != Z_STREAM_END) std::abort();
  out.resize(z.total_out);
  ::deflateEnd(&z);
  return out;
}

inline std::string png_header(const PngSpec& spec) {
  std::string data = big_endian(spec.width) + big_endian(spec.height);
  for (const int byte : {spec.bits, spec.colour, 0, 0, spec.interlace}) data += static_cast<char>(byte);
  return png_chunk("IHDR", data);
}

/// The PNG file around a zlib stream. The stream may be invalid or of another size than the header says.
inline std::string png_around(const PngSpec& spec, const std::string& stream) {
  std::string out = std::string(png_signature) + png_header(spec);
  if (spec.colour == 3) {
    std::string palette;
    for (int i = 0; i < 3 << spec.bits; ++i) palette += static_cast<char>(i * 7);
    out += png_chunk("PLTE", palette);
  }
  out += spec.before;
  const std::size_t piece = spec.idat == 0 ? stream.size() : spec.idat;
  for (std::size_t at = 0; at < stream.size(); at += piece) {
    if (spec.empty_idats) out += png_chunk("IDAT", "");
    out += png_chunk("IDAT", stream.substr(at, piece));
  }
  if (spec.empty_idats) out += png_chunk("IDAT", "");
  return out + spec.behind + png_chunk("IEND", "");
}

inline std::string make_png(const PngSpec& spec) {
  return png_around(spec, zlib_stream(png_filtered_rows(spec), spec.level, spec.strategy, spec.window));
}

}  // namespace etak::test
