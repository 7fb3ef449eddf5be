// SPDX-License-Identifier: Apache-2.0
// The format of picture_bytes.h: of core, because scenes name it for their pictures without reading them.
#include <array>
#include <cctype>

#include "core/base/text/ascii.h"
#include "core/image/files/png_chunks.h"
#include "core/image/picture_bytes.h"

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
    Signature{{"GIF", 3}, "gif"},  // all that its decoder asks for
    Signature{{"BM", 2}, "bmp"},
    Signature{{"DDS ", 4}, "dds"},
    Signature{{"\xABKTX 20\xBB\r\n\x1A\n", 12}, "ktx2"},
    Signature{{"8BPS", 4}, "psd"},
    Signature{{"SDPX", 4}, "dpx"},
    Signature{{"XPDS", 4}, "dpx"},
    Signature{{"\0\0\0\x0CjP  \r\n\x87\n", 12}, "jpeg2000"},
};

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
  if (lower_case(name).ends_with(".tga")) return "targa";
  return {};
}

}  // namespace etak
