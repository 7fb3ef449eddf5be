// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/image/image.h"

namespace etak {

// The one door to OpenImageIO (target etak::image_io, only where that library is found; no part of
// etak::core, so that the start-up program stays light).
//
// The fourth channel of etak's pictures is gloss as often as opacity, and colour under opacity 0 counts.
// OpenImageIO takes a fourth channel of a PNG for opacity and multiplies the colour by it (its issues 528,
// 760, 2887, 3917, 4314), losing both; so every input is opened and every output written with
// oiio:UnassociatedAlpha = 1.
//
// All throw Error that names the path.

/// What a file says of itself.
struct ImageInfo {
  int width = 0, height = 0, channels = 0;
  int bits = 0;           // of one value: 8, 16, 32
  bool floating = false;  // half or float
  std::string format;     // "png", "openexr", "hdr", ...
};
ImageInfo read_image_info(const std::string& path);

/// Any picture file OpenImageIO knows, 8- and 16-bit codes as code / 255 and code / 65535. No curve is
/// undone: PNG codes stay encoded. At most max_image_side on a side and 4 channels.
Image read_image(const std::string& path);

/// The codes of an 8-bit file, untouched. Throws Error for files of another depth.
Image8 read_image8(const std::string& path);

/// The whole file is made in memory and put in place at once (write_file of core/base/file.h).
///   overwrite   false: an existing file is an Error
void write_png(const std::string& path, const Image8& image, bool overwrite);

/// OpenEXR, ZIP compression.
///   floats   32-bit values; else half: 11 bits of precision, at most 65504 (larger ones are written as that)
void write_exr(const std::string& path, const Image& image, bool floats, bool overwrite);

}  // namespace etak
