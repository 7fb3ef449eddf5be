// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/image/files/png.h"

namespace etak::test {

/// A picture as the bytes of a PNG file, with an sRGB chunk where `srgb`.
inline std::string png_of(const Image8& image, bool srgb = false) {
  PngOptions options;
  options.srgb = srgb;
  return png_bytes(image, options);
}

/// Reads a whole picture of 8 bits by PngReader, with its forms and errors; nullopt for pictures of 16 bits
/// too.
inline std::optional<Image8> read_png8(std::string_view bytes, std::string_view path) {
  std::optional<PngReader> reader = PngReader::open(bytes, path);
  if (!reader || reader->header().bits != 8) return std::nullopt;
  const PictureHeader& header = reader->header();
  Image8 out(header.width, header.height, header.channels);
  reader->read_rows(out.values.data(), static_cast<std::size_t>(out.width * out.channels), out.height);
  return out;
}

}  // namespace etak::test
