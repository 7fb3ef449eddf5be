// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_chunks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/image/files/deflate.h"
#include "core/image/files/icc.h"
#include "core/image/files/png.h"

namespace etak {
namespace {

// A chunk may be as long as the file, so its checksum is taken in pieces, which stay in the second-level
// cache.
constexpr std::size_t piece_bytes = std::size_t{64} << 10;

// Inflates the data of a chunk behind its first `skip` bytes. Empty where the data are damaged, or where they
// have more than `most` bytes deflated or inflated.
std::string inflated(ByteSource& bytes, const PngChunk& chunk, std::size_t skip, std::size_t most) {
  std::string out;
  if (chunk.size > most) return out;
  Inflater inflater;
  for (std::size_t at = skip; at < chunk.size;) {
    const std::string piece(bytes.view(chunk.data() + at, std::min(piece_bytes, chunk.size - at)));
    at += piece.size();
    inflater.feed(octets(piece));
    for (auto status = Inflater::Status::more; status != Inflater::Status::hungry;) {
      std::array<std::uint8_t, 16384> part;
      std::size_t written = 0;
      status = inflater.read(part, written);
      out.append(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(written));
      if (status == Inflater::Status::damaged || out.size() > most) return {};
      if (status == Inflater::Status::ended) return out;
    }
  }
  return {};
}

// Reads an iCCP chunk: the name of the profile, a zero, the method of compression, the deflated profile.
void read_profile(ByteSource& bytes, const PngChunk& chunk, PictureHeader& out) {
  constexpr std::size_t most_name = 79;
  const std::string head(bytes.view(chunk.data(), std::min<std::size_t>(chunk.size, most_name + 1)));
  const std::size_t end = head.find('\0');
  const auto colors =
      end == head.npos ? std::nullopt : icc_colors(inflated(bytes, chunk, end + 2, largest_profile_bytes));
  out.colour_space = colors ? colors->curve : "icc: " + head.substr(0, std::min(end, most_name));
  out.primaries = colors ? colors->primaries : "";
}

// The primaries of a cHRM chunk: x and y of white, red, green and blue, in units of 1/100000.
std::string primaries_of(std::string_view chunk) {
  std::array<std::array<double, 2>, 4> xy{};
  for (std::size_t i = 0; i < 8; ++i) xy[i / 2][i % 2] = big_endian(chunk, 4 * i) / 1e5;
  return primaries_name({xy[1], xy[2], xy[3]}, xy[0]);
}

// The code points of ITU-T H.273 that a cICP chunk holds.
std::string primaries_of_code_point(char code) {
  if (code == 1) return "sRGB";
  if (code == 9) return "Rec. 2020";
  return code == 12 ? "Display P3" : "others";
}
std::string curve_of_code_point(char code) {
  if (code == 4) return "power-2.2";
  if (code == 8) return "linear";
  if (code == 13) return "srgb";
  if (code == 16) return "PQ";
  return code == 18 ? "HLG" : "a curve of its own";
}

}  // namespace

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i) out = out << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return out;
}

std::optional<PngChunk> png_chunk_at(ByteSource& bytes, std::size_t start) {
  if (start > bytes.size() || bytes.size() - start < png_chunk_overhead) return std::nullopt;
  const std::string_view head = bytes.view(start, 8);
  const std::size_t size = big_endian(head, 0);
  if (size > bytes.size() - start - png_chunk_overhead) return std::nullopt;
  return PngChunk{start, size, std::string(head.substr(4))};
}

bool has_png_signature(ByteSource& bytes) {
  return bytes.size() >= png_signature.size() && bytes.view(0, png_signature.size()) == png_signature;
}

std::uint32_t stored_checksum(ByteSource& bytes, const PngChunk& chunk) {
  return big_endian(bytes.view(chunk.end() - 4, 4), 0);
}

std::uint32_t checksum(ByteSource& bytes, const PngChunk& chunk) {
  std::uint32_t out = 0;
  for (std::size_t at = chunk.start + 4, left = chunk.size + 4; left > 0;) {
    const std::size_t take = std::min(left, piece_bytes);
    out = crc32_of(out, octets(bytes.view(at, take)));
    at += take;
    left -= take;
  }
  return out;
}

PngForm png_form(std::string_view ihdr) {
  const auto byte = [&](std::size_t i) { return int{static_cast<std::uint8_t>(ihdr[i])}; };
  return {big_endian(ihdr, 0), big_endian(ihdr, 4), byte(8), byte(9), byte(10), byte(11), byte(12)};
}

int png_channels(int colour) {
  constexpr std::array channels{1, 0, 3, 1, 2, 0, 4};
  return colour < 7 ? channels[static_cast<std::size_t>(colour)] : 0;
}

std::optional<PictureHeader> png_header(ByteSource& bytes) {
  if (!has_png_signature(bytes)) return std::nullopt;
  PictureHeader out;
  out.format = "png";
  bool says_srgb = false;  // which wins over profile, primaries and power; cICP wins over all
  for (auto chunk = png_chunk_at(bytes, png_signature.size()); chunk && chunk->type != "IDAT";
       chunk = png_chunk_at(bytes, chunk->end())) {
    const std::string_view data = bytes.view(chunk->data(), std::min<std::size_t>(chunk->size, 13));
    if (chunk->start == png_signature.size() && chunk->type == "IHDR" && chunk->size == 13) {
      const PngForm form = png_form(data);
      const auto side = [](std::uint32_t s) { return s >= 1 && s <= std::uint32_t{max_image_side}; };
      out.width = static_cast<int>(form.width);
      out.height = static_cast<int>(form.height);
      out.channels = png_channels(form.colour);
      out.bits = std::max(8, form.bits);
      out.palette = form.colour == 3;
      out.strips = (form.bits == 8 || form.bits == 16) && out.channels != 0 && !out.palette &&
                   form.interlace == 0 && side(form.width) && side(form.height);
    }
    if (chunk->type == "gAMA" && chunk->size == 4 && out.colour_space.empty())
      out.colour_space = power_curve_name(big_endian(data, 0) / 1e5);
    if (chunk->type == "cHRM" && chunk->size == 32 && out.primaries.empty())
      out.primaries = primaries_of(bytes.view(chunk->data(), 32));
    if (chunk->type == "iCCP" && !says_srgb) read_profile(bytes, *chunk, out);
    if (chunk->type == "sRGB") {
      says_srgb = true;
      out.colour_space = "srgb";
      out.primaries.clear();
    }
    if (chunk->type == "cICP" && chunk->size == 4) {
      out.colour_space = curve_of_code_point(data[1]);
      out.primaries = primaries_of_code_point(data[0]);
      break;
    }
  }
  return out;
}

}  // namespace etak
