// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/files/file_stamp.h"
#include "core/image/load.h"

namespace etak {

class FileBytes;

/// Colours of a space that etak does not have itself: linear sRGB from its values, `count` pixels of three in
/// place.
using SpaceCurve = std::function<void(float* rgb, std::size_t count)>;

/// How the numbers of a file become what a texture holds: both as fractions of full scale, encoded.
///   apply   empty: unchanged. May leave [0, 1]; such values are brought back and counted
struct CodeCurve {
  std::function<double(double)> apply;
  std::function<double(double)> apply_float;  // for files of floats, whose colours are linear by themselves

  /// Linear light from the numbers of colours, for outputs of floats. Empty: they are sRGB-encoded.
  std::function<double(double)> linear, linear_float;

  /// The output code of every input code of files of `bits` (8 or 16), and whether it had to be clamped.
  std::vector<std::uint8_t> codes(int bits, std::vector<bool>* clamped = nullptr) const;
};

/// Picture files that were decoded already, by their paths, with the state that they had.
struct DecodedFile {
  FileStamp stamp;
  std::shared_ptr<const Picture> picture;
};
using DecodedFiles = std::map<std::string, DecodedFile>;

/// Decodes files, several at once.
///   known   files that need not be decoded again where they have not changed
DecodedFiles decoded_files(std::vector<std::string> paths, const PictureDoor& door,
                           const DecodedFiles& known = {});

/// The colour or the grey part of one texture of a material.
struct PlaneSource {
  std::string path;                        // of the picture; empty: `constant` everywhere
  bool color = true;                       // three channels, else one
  std::array<int, 3> pick{0, 1, 2};        // which channels of the picture; [0] alone for grey
  bool picked = false;                     // the manifest named the channels: they must be there
  std::shared_ptr<const CodeCurve> curve;  // none: codes stay as they are
  SpaceCurve space;                        // of a colour; then there is no curve
  std::string space_name;                  // "" for the usual
  std::array<std::uint8_t, 3> constant{};
  std::array<double, 3> exact{};          // what `constant` is the code of: linear light, or a plain quantity
  std::string layers = {};                // of an F0 that layers on a base make: their text
  const PictureDoor* door = nullptr;      // for pictures that are not read in strips
  const DecodedFiles* decoded = nullptr;  // is looked at first, when the plane is opened

  bool is_image() const { return !path.empty(); }
  /// The decoded file; null where it is still to be read.
  std::shared_ptr<const Picture> known() const;
};

/// Reads the header of a picture file: of PNG here, of other formats by `door`. Throws Error.
PictureHeader picture_header(const std::string& path, const PictureDoor& door);

/// Which channels of a picture that has so many the source takes: a grey picture serves as a colour. Throws
/// Error for channels that are not there.
std::array<int, 3> picked_channels(const PlaneSource& source, int channels);

/// Throws Error: the picture of the source holds a value that is not finite.
[[noreturn]] void refuse_not_finite(const PlaneSource& source);

/// Throws Error where a picture of `width` x `height` is not as large as it was when its header was read.
void check_size(const PlaneSource& source, int width, int height, int expected_width, int expected_height);

/// Reads one plane row by row, as converted 8-bit codes.
class PlaneRows {
 public:
  /// Opens the file; its bytes go into `memory`, which must outlive this object. Throws Error for a file that
  /// cannot be read, and for channels that it does not have.
  ///   first   the first row; other than 0 only for constants and for files that are known()
  PlaneRows(const PlaneSource& source, FileBytes& memory, int first = 0);

  int width() const { return width_; }  // 0: a constant
  int height() const { return height_; }
  const PlaneSource& source() const { return *source_; }

  /// The next `count` rows, `step()` bytes a texel, without gaps; valid until the next call. Must not be
  /// called for a constant.
  const std::uint8_t* read(int count);
  int step() const { return channels_; }
  std::array<int, 3> pick() const { return source_->space ? std::array{0, 1, 2} : pick_; }

  /// Texels so far whose value had to be clamped.
  std::size_t clamped() const { return clamped_; }

 private:
  template <class Sample>
  void convert_space(const Sample* in, std::size_t texels, int step, float scale);
  template <class Sample>
  void convert(const Sample* in, std::size_t samples);
  void convert_floats();

  const PlaneSource* source_;
  std::optional<ValueRows> file_;
  int width_ = 0, height_ = 0;
  int file_channels_ = 0, channels_ = 0;  // as read; as given
  std::array<int, 3> pick_{0, 1, 2};
  std::vector<std::uint8_t> codes_, raw_, rows_;
  std::vector<std::uint16_t> wide_;
  std::vector<float> values_, floats_;  // of a file of floats; in the space
  std::vector<bool> clamps_;
  bool may_clamp_ = false;
  std::size_t clamped_ = 0;
};

/// Interleaves a colour and a grey row to RGBA. Either may be null: the constant then.
void interleave(std::uint8_t* rgba, std::size_t texels, const std::uint8_t* color,
                const PlaneRows& color_rows, const std::uint8_t* grey, const PlaneRows& grey_rows);

}  // namespace etak
