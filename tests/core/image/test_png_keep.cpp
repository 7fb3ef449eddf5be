// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_keep.h"

#include <catch2/catch.hpp>

#include "core/image/files/deflate.h"
#include "core/image/files/png.h"
#include "core/image/files/png_chunks.h"
#include "core/image/load.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string number_of(std::uint32_t value) {
  std::string out;
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(value >> shift & 255);
  return out;
}

std::string chunk_of(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  return number_of(static_cast<std::uint32_t>(data.size())) + body + number_of(crc32_of(0, octets(body)));
}

// The types of a file's chunks in their order.
std::string types_of(const std::string& file) {
  BytesInMemory bytes(file);
  std::string out;
  for (auto chunk = png_chunk_at(bytes, png_signature.size()); chunk;
       chunk = png_chunk_at(bytes, chunk->end()))
    out += (out.empty() ? "" : " ") + chunk->type;
  return out;
}

}  // namespace

TEST_CASE("a PNG file with new texels keeps what the old one said beside its texels") {
  const Image8 old_texels(8, 8, 3, 40), new_texels(8, 8, 3, 90), with_alpha(8, 8, 4, 90);
  const std::string plain = png_bytes(PngRows(old_texels), {});
  const std::size_t behind_header = png_signature.size() + png_chunk_overhead + 13,
                    before_end = plain.size() - png_chunk_overhead;
  const std::string original =
      plain.substr(0, behind_header) + chunk_of("gAMA", number_of(45455)) +
      chunk_of("pHYs", number_of(2835) + number_of(2835) + '\1') + chunk_of("sBIT", "\5\5\5") +
      chunk_of("tIME", std::string("\x07\xe6\1\1\1\1\1", 7)) + chunk_of("acTL", number_of(1) + number_of(0)) +
      plain.substr(behind_header, before_end - behind_header) +
      chunk_of("tEXt", std::string("Author\0etak", 11)) + plain.substr(before_end);
  BytesInMemory source(original);
  const PngWithChunks kept = with_chunks_of(png_bytes(PngRows(new_texels), {}), source);
  CHECK(types_of(kept.file) == "IHDR gAMA pHYs sBIT IDAT tEXt IEND");
  CHECK(kept.left_out == std::vector<std::string>{"tIME", "acTL"});
  const Picture picture = load_picture(kept.file, "kept.png", {});
  CHECK(std::get<Image8>(picture.pixels) == new_texels);
  // Of another colour type, chunks about the form stay out.
  const PngWithChunks other = with_chunks_of(png_bytes(PngRows(with_alpha), {}), source);
  CHECK(types_of(other.file) == "IHDR gAMA pHYs IDAT tEXt IEND");
}

TEST_CASE("of a PNG file only what its texels depend on is needed, up to IEND") {
  const Image8 texels(8, 8, 3, 40);
  const std::string plain = png_bytes(PngRows(texels), {});
  const std::size_t behind_header = png_signature.size() + png_chunk_overhead + 13,
                    before_end = plain.size() - png_chunk_overhead;
  const std::string original = plain.substr(0, behind_header) + chunk_of("gAMA", number_of(45455)) +
                               chunk_of("tRNS", std::string("\0\1\0\1\0\1", 6)) +
                               plain.substr(behind_header, before_end - behind_header) +
                               chunk_of("tEXt", std::string("Author\0etak", 11)) + plain.substr(before_end) +
                               "behind its end";
  BytesInMemory source(original);
  const auto alone = texels_alone(source);
  REQUIRE(alone);
  CHECK(types_of(*alone) == "IHDR tRNS IDAT IEND");
  CHECK(alone->size() == size_of_texels_alone(source));
  BytesInMemory bare(plain), cut(std::string_view(original).substr(0, before_end)), other("no PNG at all");
  CHECK(texels_alone(bare) == plain);
  CHECK(texels_alone(cut) == std::nullopt);
  CHECK(size_of_texels_alone(cut) == std::nullopt);
  CHECK(texels_alone(other) == std::nullopt);
}
