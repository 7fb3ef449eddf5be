// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "core/image/files/png.h"
#include "core/image/picture.h"

namespace etak {

// Pictures of any kind as they are in the file (target etak::textures): PNG by core/image/files/png.h, all
// others and the forms of PNG that it leaves out by the door of the caller.

/// Throws Error that names `path` for a file that changes while it is read, and for anything but a whole
/// picture of 1 to max_image_side pixels on a side and 1 to 4 channels: see image_io.h and, for PNG,
/// PngReader of png.h.
Picture load_picture(const std::string& path, const PictureDoor& door);

/// The same of a file that is in memory, such as an image in a glTF buffer.
///   label   for messages
Picture load_picture(std::string_view bytes, const std::string& label, const PictureDoor& door);
Picture load_picture(const PictureFile& file, const PictureDoor& door);

/// A picture's rows from the top in the values that its file has, in the machine's byte order: of a PNG as
/// they are asked for, of others from the whole picture.
class ValueRows {
 public:
  explicit ValueRows(PngReader png) : from_(std::move(png)) {}
  explicit ValueRows(Picture picture) : from_(std::move(picture)) {}
  const PictureHeader& header() const;
  /// The next `count` rows, row i at out + i * stride. Throws Error for broken data.
  void read(std::uint8_t* out, std::size_t stride, int count);

 private:
  std::variant<PngReader, Picture> from_;
  int next_ = 0;
};

/// A picture file, opened: PNG is read row by row, all else at once by the door. Throws Error that names the
/// path.
std::unique_ptr<RowSource> open_picture(const std::string& path, const PictureDoor& door);
std::unique_ptr<RowSource> open_picture(const PictureFile& file, const PictureDoor& door);

/// The same of a file that can be read row by row; null for others.
std::unique_ptr<RowSource> open_rows(const std::string& path);

/// A picture as codes, 16 bits rounded to 8. Floats are clamped to 0..1. Channels as stored.
///   floats_linear   floats are linear light and are, but for the fourth channel, encoded to sRGB; else they
///                   are fractions of full scale
Image8 codes_of(Picture picture, bool floats_linear);

}  // namespace etak
