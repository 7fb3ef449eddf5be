// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>

#include "core/image/image.h"

namespace etak {

/// What a file says of itself.
struct ImageInfo {
  int width = 0, height = 0, channels = 0;
  int bits = 0;           // of one value: 8, 16, 32
  bool floating = false;  // half or float
  std::string format;     // "png", "openexr", "hdr", ...
  // What went in was changed by the compression: JPEG, lossy WebP, DWA, block formats, ...
  bool lossy = false;
  bool icc_profile = false;  // an ICC profile is embedded
  bool srgb_tag = false;     // EXIF says sRGB
  std::string colour_space;  // oiio:ColorSpace: what the file says, or OpenImageIO's guess from the format
};
/// A picture in the kind of values its file has: 8-bit codes, 16-bit codes, or float for the rest.
struct AnyImage {
  ImageInfo info;
  std::variant<Image8, Image16, Image> pixels;
};

/// How pictures that are no plain PNG are decoded. The program says it: by OpenImageIO (image_io_decoder() of
/// image_io.h), or by what loads that library (120 MB, a quarter of a second) when it is first needed. Both
/// throw Error that names the file. Empty functions: such pictures are refused.
///   label   of the bytes, for messages
struct PictureDecoder {
  std::function<AnyImage(const std::string& path)> file;
  std::function<AnyImage(std::string_view bytes, const std::string& label)> bytes;
};

}  // namespace etak
