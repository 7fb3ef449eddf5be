// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "core/image/files/png.h"

namespace etak::test {

/// A picture as the bytes of a PNG file, with an sRGB chunk where `srgb`.
inline std::string png_of(const Image8& image, bool srgb = false) {
  PngOptions options;
  options.srgb = srgb;
  return png_bytes({{image.width, image.height, image.channels, 8},
                    image.values.data(),
                    static_cast<std::size_t>(image.width * image.channels)},
                   options);
}

}  // namespace etak::test
