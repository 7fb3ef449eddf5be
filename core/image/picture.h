// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/image/blocks/astc_door.h"
#include "core/image/image.h"
#include "core/image/pixels_view.h"
#include "core/math/mesh_door.h"

namespace etak {

/// Size of the largest picture file that is read, in bytes.
inline constexpr std::size_t largest_picture_bytes =
    std::min<std::uint64_t>(std::uint64_t{1} << 32, std::numeric_limits<std::size_t>::max());

/// What the header of a picture file says about the picture.
struct PictureHeader {
  int width = 0, height = 0;
  int channels = 0;       // of the decoded picture; for a palette, the channels of its colours
  int bits = 8;           // of a value in the file: 8 (also for fewer), 16 (codes or half floats) or 32
  bool floating = false;  // decoded as floats: half, float, and integers of more than 16 bits
  bool palette = false;   // the file holds codes of a palette
  bool strips = false;    // a PNG of a form whose rows PngReader reads one by one; tRNS is not looked at
  bool lossy = false;     // the compression changed the values: JPEG, lossy WebP, DWA, block formats
  std::string format{};   // OpenImageIO's name of the format: "png", "jpeg", "openexr", ...
  // The transfer curve that the file declares: "srgb", "linear", "power-2.2", "gamma 0.6", "a curve of its
  // own", or "icc: NAME" for a colour profile that icc_colors() cannot read; empty where the file declares
  // none.
  std::string colour_space{};
  std::string primaries{};    // of the colour profile, as icc_colors() names them; empty without one
  std::string blocks{};       // of a texture in blocks: the name of their format, as block_formats has it
  double bits_per_texel = 0;  // of these blocks
  friend bool operator==(const PictureHeader&, const PictureHeader&) = default;
};

/// The header of a picture in memory.
template <class Value>
PictureHeader header_of(const Pixels<Value>& pixels) {
  return {pixels.width, pixels.height, pixels.channels, static_cast<int>(8 * sizeof(Value)),
          sizeof(Value) > 2};
}

/// A picture in the kind of values that its file has: 8-bit codes, 16-bit codes, or floats for all others. No
/// transfer curve is undone, colour is not multiplied by the last channel, and NaN and infinity are kept.
struct Picture {
  PictureHeader header;
  std::variant<Image8, Image16, Image> pixels;
};

/// A picture file, on disk or in memory.
struct PictureFile {
  std::string path;   // of a file on disk; empty where `bytes` holds the file
  std::string bytes;  // the whole file: PNG, JPEG, ...
  std::string label;  // for messages: the path, or the name of the thing that contains the bytes
};

/// A line of text as the part of each pixel that it covers, in one channel.
///   left, top   place of its first column and row from the point where the text begins on its base line
struct TextPicture {
  Image coverage;
  int left = 0, top = 0;
};

/// The functions by which pictures that PngReader does not read are decoded, by which files of floats are made,
/// and by which text is drawn. The program chooses them: picture_door() of image_io.h, which uses OpenImageIO, or functions that
/// load that library (120 MB, a quarter of a second) when it is first needed. All throw Error that names the
/// file. Where the functions are empty, such pictures are refused.
///   header, file   read the header, or the whole picture, of the file at `path`
///   bytes          reads a file in memory; `label` names it in messages
///   encode         makes a file of 32-bit floats of format "tiff" or "exr", whose fourth channel `fourth` names, or of
///                  format "webp" a lossless one of codes of 8 bits, which are given as fractions
///   text           draws a line of text in DejaVu Sans; `size` of the font in pixels
///   mesh           decompresses meshes of scenes
///   astc           compresses and decodes textures of ASTC
struct PictureDoor {
  std::function<PictureHeader(const std::string& path)> header;
  std::function<Picture(const std::string& path)> file;
  std::function<Picture(std::string_view bytes, const std::string& label)> bytes;
  std::function<std::string(const Image& image, std::string_view format, std::string_view fourth)> encode;
  std::function<TextPicture(std::string_view text, int size)> text;
  MeshDoor mesh;
  AstcDoor astc;
};

/// The rows of a picture from the top, as RGBA: grey is copied to three channels, and a missing fourth
/// channel is 255 (1 for floats). Codes of 16 bits are rounded to 8; floats come as they are.
class RowSource {
 public:
  explicit RowSource(PictureHeader header) : header_(std::move(header)) {}
  virtual ~RowSource() = default;
  const PictureHeader& header() const { return header_; }
  /// Writes the next `count` rows: 4 bytes a texel, rows `stride` bytes apart. Throws Error for broken data.
  virtual void read_rows(std::uint8_t* rgba, std::size_t stride, int count) = 0;
  /// Writes the next `count` rows of a picture of floats (header().floating): 4 floats a texel, rows `stride`
  /// floats apart, RGB in linear light. Throws Error for broken data.
  virtual void read_float_rows(float* rgba, std::size_t stride, int count);

 protected:
  PictureHeader header_;
};

/// Rows of a picture in memory (1 to 4 channels), which must outlive the source.
std::unique_ptr<RowSource> rows_of(const Image8& image);

/// Rows of pixels that the caller keeps in memory, under the header of the file to be written.
std::unique_ptr<RowSource> rows_of(const ConstPixelsView8& pixels, PictureHeader header);

/// A texel of 1 to 4 channels as red, green, blue and a fourth value: grey is copied to three channels, and a
/// missing fourth is `full`.
template <class Value>
std::array<Value, 4> four_channels(const Value* texel, std::size_t channels, Value full) {
  switch (channels) {
    case 1:
      return {texel[0], texel[0], texel[0], full};
    case 2:
      return {texel[0], texel[0], texel[0], texel[1]};
    case 3:
      return {texel[0], texel[1], texel[2], full};
    default:
      return {texel[0], texel[1], texel[2], texel[3]};
  }
}

}  // namespace etak
