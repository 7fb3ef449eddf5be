// SPDX-License-Identifier: Apache-2.0
#include "core/image/picture_bytes.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/base/error.h"
#include "core/image/files/png.h"
#include "core/image/image.h"

namespace etak {
namespace {

// Codes of a GIF file have 12 bits at most, and a code stands for 4096 pixels at most (GIF89a, appendix F).
constexpr std::size_t most_gif_pixels_a_byte = 4096 * 8 / 12;

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < size; ++i)
    out = out << 8 | static_cast<std::uint8_t>(bytes[at + (big_endian ? i : size - 1 - i)]);
  return out;
}

[[noreturn]] void fail_cut(std::string_view label) {
  throw Error::at(label, "is cut short", "a whole picture file");
}

// A JPEG file (ITU-T T.81, B.1.1) is a row of segments, each with its length, up to the first scan; then
// coded data follow, and the marker EOI ends the picture. The EOI of a thumbnail lies inside a segment and is
// skipped with it.
void check_jpeg(std::string_view bytes, std::string_view label) {
  std::size_t at = 2;
  for (;;) {
    if (at + 4 > bytes.size() || bytes[at] != '\xFF') fail_cut(label);
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (marker == 0xFF) {
      ++at;  // fill byte
      continue;
    }
    at += 2 + number(bytes, at + 2, 2, true);
    if (marker == 0xDA) break;
  }
  if (at > bytes.size() || bytes.find("\xFF\xD9", at) == std::string_view::npos) fail_cut(label);
}

void check_webp(std::string_view bytes, std::string_view label) {
  if (bytes.size() < 20 || number(bytes, 4, 4, false) > bytes.size() - 8) fail_cut(label);
}

// The container format of WebP (RFC 9649, 2.5 to 2.7): the first chunk is a lossy frame, a lossless one, or the head
// of an extended file, whose canvas holds all frames.
std::optional<StatedSize> webp_size(std::string_view bytes) {
  if (bytes.size() < 30) return {};
  const std::string_view chunk = bytes.substr(12, 4);
  if (chunk == "VP8 ")
    return StatedSize{number(bytes, 26, 2, false) & 0x3FFF, number(bytes, 28, 2, false) & 0x3FFF};
  if (chunk == "VP8L") {
    const std::uint32_t sides = number(bytes, 21, 4, false);
    return StatedSize{(sides & 0x3FFF) + 1, (sides >> 14 & 0x3FFF) + 1};
  }
  if (chunk == "VP8X") return StatedSize{number(bytes, 24, 3, false) + 1, number(bytes, 27, 3, false) + 1};
  return {};
}

// A BMP file starts with 14 bytes, then the size of the next head: 12 in the oldest form, whose sides have two bytes.
// A height below 0 means rows from the top.
std::optional<StatedSize> bmp_size(std::string_view bytes) {
  if (bytes.size() < 26) return {};
  if (number(bytes, 14, 4, false) == 12)
    return StatedSize{number(bytes, 18, 2, false), number(bytes, 20, 2, false)};
  const auto height = static_cast<std::int32_t>(number(bytes, 22, 4, false));
  return StatedSize{number(bytes, 18, 4, false), static_cast<std::size_t>(std::abs(std::int64_t{height}))};
}

// Looks for the first chunk with picture data: "VP8 " is lossy, "VP8L" lossless. In the extended file format
// other chunks come before it, and in animations it lies inside of "ANMF".
bool webp_is_lossy(std::string_view bytes) {
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::string_view type = bytes.substr(at, 4);
    if (type == "VP8 ") return true;
    if (type == "VP8L") return false;
    if (type == "ANMF") {
      at += 8 + 16;
      continue;
    }
    const std::size_t size = number(bytes, at + 4, 4, false);
    at += 8 + size + size % 2;
  }
  return false;
}

}  // namespace

bool is_lossy(std::string_view bytes, std::string_view format, std::string_view compression) {
  if (format == "jpeg" || format == "jpeg2000" || format == "heif") return true;
  if (format == "webp") return webp_is_lossy(bytes);
  // The compressions of OpenEXR that drop bits (pxr24 drops those of floats), JPEG in TIFF, and the block
  // formats of DDS.
  for (const std::string_view lossy : {"dwa", "b44", "pxr24", "jpeg", "DXT", "BC"})
    if (compression.starts_with(lossy)) return true;
  return false;
}

std::optional<StatedSize> stated_size(std::string_view bytes, std::string_view format) {
  if (format == "webp") return webp_size(bytes);
  if (format == "bmp") return bmp_size(bytes);
  if (format == "gif" && bytes.size() >= 10)
    return StatedSize{number(bytes, 6, 2, false), number(bytes, 8, 2, false)};
  return {};
}

void check_size(const StatedSize& size, std::string_view label) {
  if (size.width < 1 || size.height < 1 || size.width > max_image_side || size.height > max_image_side)
    throw Error::at(label,
                    "is " + std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels",
                    "1 to " + std::to_string(max_image_side) + " on a side");
}

void check_whole(std::string_view bytes, std::string_view format, std::string_view label) {
  if (format == "png") check_png(bytes, label);
  if (format == "jpeg") check_jpeg(bytes, label);
  if (format == "webp") check_webp(bytes, label);
  const std::optional<StatedSize> size = stated_size(bytes, format);
  if (!size) return;
  check_size(*size, label);
  if (format == "gif" && size->width * size->height > most_gif_pixels_a_byte * bytes.size())
    throw Error::at(
        label, "states " + std::to_string(size->width) + " x " + std::to_string(size->height) + " pixels",
        "no more than its " + std::to_string(bytes.size()) + " bytes can hold");
}

}  // namespace etak
