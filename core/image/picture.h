// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/image/image.h"
#include "core/image/pixels_view.h"

namespace etak {

/// The largest picture file that is read.
inline constexpr std::size_t largest_picture_bytes = std::size_t{1} << 32;

/// What a picture file says of itself.
struct PictureHeader {
  int width = 0, height = 0;
  int channels = 0;       // as they come out; of a palette's codes those of its colours
  int bits = 8;           // of a value in the file: 8, 16 (codes or half), 32; 8 for fewer
  bool floating = false;  // values come as floats: half, float and integers of more than 16 bits
  bool palette = false;   // codes of a palette
  bool strips = false;    // a PNG whose rows PngReader reads one by one
  bool lossy = false;     // compressing changed the values: JPEG, lossy WebP, DWA, block formats
  std::string format{};   // "png", "jpeg", "openexr", ...: OpenImageIO's names
  // The declared curve: "srgb", "linear", "gamma22", "gamma 0.6", "a curve of its own", or "icc: NAME" for a
  // colour profile that icc_colors() cannot read; empty: not said.
  std::string colour_space{};
  std::string primaries{};  // of a colour profile, as icc_colors() names them; empty: no profile
  friend bool operator==(const PictureHeader&, const PictureHeader&) = default;
};

/// That of values in memory.
template <class Value>
PictureHeader header_of(const Pixels<Value>& pixels) {
  return {pixels.width, pixels.height, pixels.channels, static_cast<int>(8 * sizeof(Value)),
          sizeof(Value) > 2};
}

/// A picture in the kind of values its file has: 8-bit codes, 16-bit codes, or float for the rest. No curve
/// is undone, colour is not multiplied by the last channel, NaN and infinity stay.
struct Picture {
  PictureHeader header;
  std::variant<Image8, Image16, Image> pixels;
};

/// The bytes of a picture file: in a file, or in memory.
struct PictureFile {
  std::string path;   // empty: `bytes` holds the file
  std::string bytes;  // PNG, JPEG, ...
  std::string label;  // for messages: the path, or what the bytes are a part of
};

/// How pictures that are no plain PNG are read, and files of floats written. The program says it: by
/// OpenImageIO (picture_door() of image_io.h), or by what loads that library (120 MB, a quarter of a second)
/// when it is first needed. All throw Error that names the file. Empty functions: such pictures are refused.
///   label    of the bytes, for messages
///   encode   a file of 32-bit floats, "tiff" or "exr"; `fourth` names the fourth channel
struct PictureDoor {
  std::function<PictureHeader(const std::string& path)> header;
  std::function<Picture(const std::string& path)> file;
  std::function<Picture(std::string_view bytes, const std::string& label)> bytes;
  std::function<std::string(const Image& image, std::string_view format, std::string_view fourth)> encode;
};

/// Rows of one picture from the top, as RGBA codes: grey is spread over three channels, a missing fourth is
/// 255, 16 bits are rounded to 8. Of float pictures the values as they are.
class RowSource {
 public:
  explicit RowSource(PictureHeader header) : header_(std::move(header)) {}
  virtual ~RowSource() = default;
  const PictureHeader& header() const { return header_; }
  /// The next `count` rows; 4 bytes a texel, rows `stride` bytes apart. Throws Error for broken data.
  virtual void read_rows(std::uint8_t* rgba, std::size_t stride, int count) = 0;
  /// Only where header().floating: 4 floats a texel, rows `stride` floats apart; RGB linear.
  virtual void read_float_rows(float* rgba, std::size_t stride, int count);

 protected:
  PictureHeader header_;
};

/// Rows of a picture in memory (1 to 4 channels), which must outlive the source.
std::unique_ptr<RowSource> rows_of(const Image8& image);

/// Rows of pixels that the caller keeps in memory, under the header of the file to be written.
std::unique_ptr<RowSource> rows_of(const ConstPixelsView8& pixels, PictureHeader header);

/// A texel as red, green, blue and a fourth: grey is spread over three, a missing fourth is `full`.
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
