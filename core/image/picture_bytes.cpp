// SPDX-License-Identifier: Apache-2.0
#include "core/image/picture_bytes.h"

#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/image/files/png.h"
#include "core/image/files/png_chunks.h"

namespace etak {
namespace {

struct Signature {
  std::string_view bytes, format;
};

constexpr std::array signatures{
    Signature{png_signature, "png"},
    Signature{{"\xFF\xD8\xFF", 3}, "jpeg"},
    Signature{{"\x76\x2F\x31\x01", 4}, "openexr"},
    Signature{{"#?RADIANCE", 10}, "hdr"},
    Signature{{"#?RGBE", 6}, "hdr"},
    Signature{{"II*\0", 4}, "tiff"},
    Signature{{"MM\0*", 4}, "tiff"},
    Signature{{"II+\0", 4}, "tiff"},
    Signature{{"MM\0+", 4}, "tiff"},
    Signature{{"GIF87a", 6}, "gif"},
    Signature{{"GIF89a", 6}, "gif"},
    Signature{{"BM", 2}, "bmp"},
    Signature{{"DDS ", 4}, "dds"},
    Signature{{"8BPS", 4}, "psd"},
    Signature{{"SDPX", 4}, "dpx"},
    Signature{{"XPDS", 4}, "dpx"},
    Signature{{"\0\0\0\x0CjP  \r\n\x87\n", 12}, "jpeg2000"},
};

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < size; ++i)
    out = out << 8 | static_cast<std::uint8_t>(bytes[at + (big_endian ? i : size - 1 - i)]);
  return out;
}

bool ends_in(std::string_view name, std::string_view ending) {
  return lower_case(name).ends_with(ending);
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

std::string picture_format(std::string_view bytes, std::string_view name) {
  for (const Signature& signature : signatures)
    if (bytes.starts_with(signature.bytes)) return std::string(signature.format);
  if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP") return "webp";
  if (bytes.size() >= 3 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
      std::isspace(static_cast<unsigned char>(bytes[2])) != 0)
    return "pnm";
  if (bytes.size() >= 3 && bytes[0] == 'P' && (bytes[1] == 'f' || bytes[1] == 'F') && bytes[2] == '\n')
    return "pnm";
  if (ends_in(name, ".tga")) return "targa";
  return {};
}

bool is_lossy(std::string_view bytes, std::string_view format, std::string_view compression) {
  if (format == "jpeg" || format == "jpeg2000" || format == "heif") return true;
  if (format == "webp") return webp_is_lossy(bytes);
  // The compressions of OpenEXR that drop bits (pxr24 drops those of floats), JPEG in TIFF, and the block
  // formats of DDS.
  for (const std::string_view lossy : {"dwa", "b44", "pxr24", "jpeg", "DXT", "BC"})
    if (compression.starts_with(lossy)) return true;
  return false;
}

void check_whole(std::string_view bytes, std::string_view format, std::string_view label) {
  if (format == "png") check_png(bytes, label);
  if (format == "jpeg") check_jpeg(bytes, label);
  if (format == "webp") check_webp(bytes, label);
}

}  // namespace etak
