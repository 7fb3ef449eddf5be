// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "core/image/files/png.h"
#include "core/image/picture.h"

namespace etak {

// Reads pictures of any format, in the values that the file has (target etak::textures). The common forms of
// PNG are read by core/image/files/png.h; its other forms and all other formats are read by the functions of
// the PictureDoor that the caller gives.

/// Whether files of a format, as picture_format() names it, are textures for a GPU, some of which load_picture() reads by
/// itself (containers.h): a door alone does not know all of their headers.
inline bool is_gpu_texture(std::string_view format) {
  return format == "dds" || format == "ktx2";
}

/// Reads a whole picture. Throws Error that names `path` for a file that changes while it is read, and for
/// anything but a whole picture of 1 to max_image_side pixels on a side and 1 to 4 channels: see image_io.h
/// and, for PNG, PngReader of png.h.
Picture load_picture(const std::string& path, const PictureDoor& door);

/// Loads a file that is in memory, such as an image in a glTF buffer.
///   label   names the picture in messages
Picture load_picture(std::string_view bytes, const std::string& label, const PictureDoor& door);
Picture load_picture(const PictureFile& file, const PictureDoor& door);

/// The rows of a picture from the top, in the values that its file has and in the machine's byte order. The
/// rows of a PngReader are decoded when they are asked for; those of a Picture are in memory.
class ValueRows {
 public:
  explicit ValueRows(PngReader png) : from_(std::move(png)) {}
  explicit ValueRows(Picture picture) : ValueRows(std::make_shared<const Picture>(std::move(picture)), 0) {}
  ///   first   row with which they begin
  ValueRows(std::shared_ptr<const Picture> picture, int first) : from_(std::move(picture)), next_(first) {}
  const PictureHeader& header() const;
  /// Writes the next `count` rows, row i at out + i * stride bytes. Throws Error for broken data.
  void read(std::uint8_t* out, std::size_t stride, int count);

 private:
  std::variant<PngReader, std::shared_ptr<const Picture>> from_;
  int next_ = 0;
};

/// Opens a picture file. The forms of PNG that PngReader knows are read row by row; all other pictures are
/// read at once, by the door. Throws Error that names the path.
std::unique_ptr<RowSource> open_picture(const std::string& path, const PictureDoor& door);
std::unique_ptr<RowSource> open_picture(const PictureFile& file, const PictureDoor& door);

/// Opens a file in memory, which must outlive the source.
///   label   names the picture in messages
std::unique_ptr<RowSource> open_picture(std::string_view bytes, const std::string& label,
                                        const PictureDoor& door);

/// Opens a picture file that can be read row by row; null for all others. Throws Error that names the path.
std::unique_ptr<RowSource> open_rows(const std::string& path);

/// Whether a PNG or TIFF file has 16 bits a value, all of which are values of 8 bits: multiples of 257, or of 256. False
/// for one value all over, and for any other picture. Throws Error for broken data.
bool holds_8_bits(const PictureFile& file, const PictureDoor& door);

/// A picture as 8-bit codes, with the channels that it has. Codes of 16 bits are rounded; floats are clamped
/// to 0..1, and NaN gives 0.
///   floats_linear   true: floats are linear light, and all channels but the fourth are encoded to sRGB;
///                   false: floats are fractions of full scale
Image8 codes_of(Picture picture, bool floats_linear);

}  // namespace etak
