// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the PNG reader answers with nothing, an Error, or pixels; the same pixels whether rows
// are read at once or one by one, and after writing and reading them again. The first byte says whether the
// checksums of chunks are put right first, so that what lies behind them is reached. The bytes are read as a
// colour profile too. A copy with their other chunks, as a repair makes it, and one without them have the same texels.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/image/files/deflate.h"
#include "core/image/files/icc.h"
#include "core/image/files/png.h"
#include "core/image/files/png_keep.h"

using namespace etak;

namespace {

std::span<const std::uint8_t> octets(const std::string& bytes, std::size_t at, std::size_t size) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()) + at, size};
}

void put_checksums_right(std::string& bytes) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    if (size > bytes.size() - at - 12) return;
    const std::uint32_t crc = crc32_of(0, octets(bytes, at + 4, 4 + size));
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + size + i] = static_cast<char>(crc >> (24 - 8 * i));
    at += 12 + size;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  // On the heap and of the exact size, so that reading beyond it is seen.
  std::string file(reinterpret_cast<const char*>(data) + 1, size - 1);
  if ((data[0] & 1) == 0) put_checksums_right(file);
  (void)icc_colors(file);  // what a profile's chunk would hold, without its checksum in the way
  const std::vector<char> bytes(file.begin(), file.end());
  const std::string_view view(bytes.data(), bytes.size());
  BytesInMemory source(view);
  (void)png_header(source);
  std::vector<std::uint8_t> whole;
  PictureHeader info;
  try {
    auto reader = PngReader::open(view, "f.png");
    if (!reader) return 0;
    info = reader->header();
    const std::size_t row =
        static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.channels * info.bits / 8);
    whole.resize(row * static_cast<std::size_t>(info.height));
    reader->read_rows(whole.data(), row, info.height);
  } catch (const Error&) {
    return 0;
  }
  const std::size_t row = whole.size() / static_cast<std::size_t>(info.height);
  auto again = PngReader::open(view, "f.png");
  assert(again);
  for (int y = 0; y < info.height; ++y) {
    std::vector<std::uint8_t> one(row);
    again->read_rows(one.data(), row, 1);
    assert(std::equal(one.begin(), one.end(), whole.begin() + static_cast<std::ptrdiff_t>(row) * y));
  }
  if (whole.size() > std::size_t{1} << 20) return 0;
  const std::string written =
      png_bytes({info, whole.data(), row}, {PngLevel::fast, 1u + (data[0] >> 1 & 1u)});
  auto back = PngReader::open(written, "w.png");
  assert(back && back->header().width == info.width && back->header().height == info.height &&
         back->header().channels == info.channels && back->header().bits == info.bits);
  std::vector<std::uint8_t> read(whole.size());
  back->read_rows(read.data(), row, info.height);
  assert(read == whole);
  const auto check_copy = [&](const std::string& copy) {
    auto reader = PngReader::open(copy, "c.png");
    assert(reader && reader->header().width == info.width && reader->header().height == info.height &&
           reader->header().channels == info.channels && reader->header().bits == info.bits);
    reader->read_rows(read.data(), row, info.height);
    assert(read == whole);
  };
  check_copy(with_chunks_of(written, source).file);
  if (const auto alone = texels_alone(source)) {
    assert(size_of_texels_alone(source) == alone->size());
    check_copy(*alone);
  }
  return 0;
}
