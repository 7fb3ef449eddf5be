// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/image/any_image.h"
#include "core/image/image.h"

namespace etak {

// Pictures of any kind as they are in the file (target etak::textures): PNG by core/image/files/png.h, all
// others and the forms of PNG that it leaves out by the decoder of the caller.

struct LoadedImage {
  /// 8-bit codes, 16-bit codes, or float for half and float files and integers of more bits. No curve is
  /// undone, colour is not multiplied by the last channel, NaN and infinity stay.
  std::variant<Image8, Image16, Image> pixels;

  std::string format;  // "png", "jpeg", "openexr", ...: OpenImageIO's names
  bool lossy = false;  // what went in was changed by the compression: JPEG, lossy WebP, DWA, block formats

  // What the file says of its colours.
  bool srgb = false;              // an sRGB chunk, or EXIF's colour space 1
  bool icc_profile = false;       // an ICC profile is embedded
  std::optional<double> gamma;    // PNG's gAMA chunk, 0.45455 for 1 / 2.2
  std::string oiio_colour_space;  // oiio:ColorSpace, "" for PNG that OpenImageIO did not read; often a guess

  int width() const;
  int height() const;
  int channels() const;
  int bits() const;  // of the values in `pixels`: 8, 16, 32
};

/// Throws Error that names `path` for a file that changes while it is read, and for anything but a whole
/// picture of 1 to max_image_side pixels on a side and 1 to 4 channels: see image_io.h and, for PNG,
/// PngReader of png.h.
LoadedImage load_picture(const std::string& path, const PictureDecoder& decoder);

/// The same of a file that is in memory, such as an image in a glTF buffer.
///   label   for messages
LoadedImage load_picture(std::string_view bytes, const std::string& label, const PictureDecoder& decoder);

}  // namespace etak
