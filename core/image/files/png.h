// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/picture.h"

namespace etak {

class ByteSource;  // core/base/files/steady_file.h

// Reads and writes PNG (ISO/IEC 15948) without OpenImageIO, because most of the time of packing an atlas goes
// into PNG. Data are inflated and deflated by ISA-L where it was found when etak was built, else by zlib.
// Only the forms that textures commonly have are supported: 8 and 16 bits, grey, grey + alpha, RGB, RGBA, not
// interlaced. Colour is never multiplied by the last channel. image_io.h reads all other forms (palette, 1 to
// 4 bits, Adam7, tRNS).

/// Reads the rows of a PNG file from the top. Only a strip of rows needs to be in memory at a time. The
/// reader is stricter than libpng and than the standard asks of decoders: a texture that is damaged anywhere
/// is refused. Besides what libpng refuses, these are errors: a wrong checksum of any chunk or of the image
/// data, image data that go on behind the last row, other chunks between IDAT chunks, a PLTE chunk where no
/// colour can use it, an IEND chunk with content. Bytes behind IEND are not read. One thing that libpng
/// refuses is read: a zlib header with a smaller window than the stream needs (the checksum proves that the
/// pixels are right).
class PngReader {
 public:
  /// Opens a PNG file. Throws Error for broken files of the supported forms: a bad chunk, a wrong checksum, a
  /// side above max_image_side.
  ///   bytes     the whole file; must outlive the reader
  ///   path      names the file in messages
  ///   returns   nullopt for a file that is no PNG, or that has one of the other forms
  static std::optional<PngReader> open(std::string_view bytes, std::string_view path);
  /// Opens a file that is read while its rows are asked for; `file` must outlive the reader.
  static std::optional<PngReader> open(ByteSource& file, std::string_view path);
  PngReader(PngReader&&) noexcept;
  PngReader& operator=(PngReader&&) noexcept;
  ~PngReader();

  const PictureHeader& header() const;

  /// Writes the next `count` rows, row i at out + i * stride bytes, 16-bit samples in the machine's byte
  /// order. At least `count` rows must be left. After the last row, the end of the stream and its checksum
  /// are checked too. Throws Error for truncated or damaged data.
  void read_rows(std::uint8_t* out, std::size_t stride, int count);

 private:
  friend void check_png(std::string_view bytes, std::string_view path);
  struct State;
  explicit PngReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Rows of codes in memory, `stride` bytes apart, 16-bit samples in the machine's byte order. Of the header,
/// the sides, the channels (1 grey, 2 grey + alpha, 3 RGB, 4 RGBA) and the bits are used: 8 or 16, and with one
/// channel also 1, 2 or 4, where the first code of a row stands in the highest bits of a byte.
struct PngRows {
  PictureHeader header;
  const std::uint8_t* rows = nullptr;
  std::size_t stride = 0;

  PngRows(PictureHeader header_, const std::uint8_t* rows_, std::size_t stride_)
      : header(std::move(header_)), rows(rows_), stride(stride_) {}
  /// The rows of a whole picture, which must outlive this view.
  template <class Code>
  PngRows(const Pixels<Code>& image)
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
      : PngRows(header_of(image), reinterpret_cast<const std::uint8_t*>(image.values.data()),
                static_cast<std::size_t>(image.width * image.channels) * sizeof(Code)) {}
};

/// How hard to compress. In one build of etak a level always makes the same bytes, with any number of
/// threads. Every level chooses the filter of each row by the least sum of absolute differences; rows of a
/// palette's codes and of fewer than 8 bits are not filtered.
///   fast       the default: ISA-L level 1 (without it zlib's RLE strategy)
///   small      zlib level 6
///   smallest   zlib level 9
enum class PngLevel { fast, small, smallest };

/// RGBA; those whose alpha is not 255 come first.
using PngPalette = std::vector<std::array<std::uint8_t, 4>>;

/// How a PNG file is written.
struct PngOptions {
  PngLevel level = PngLevel::fast;
  unsigned threads = 1;
  bool srgb = false;        // write an sRGB chunk (perceptual intent)
  PngPalette palette = {};  // not empty: the rows hold codes of it, of one channel and up to 8 bits
};

/// Writes a PNG file to `sink`, piece by piece and in order; `sink` is called by one thread at a time. Strips
/// of rows are filtered and deflated by options.threads threads at once. Exceptions of `sink` are passed on.
void write_png(const PngRows& image, const PngOptions& options,
               const std::function<void(std::string_view)>& sink);

/// Writes a PNG file whose rows come in bands from the top, for pictures that are never whole in memory. The
/// file is the same as that of write_png(). A band is divided into strips, which several threads of the
/// caller may make at once.
class PngBands {
 public:
  /// Buffers and compressors of the threads. Writers that share a Scratch need together no more of them than
  /// there are threads.
  class Scratch;
  static std::shared_ptr<Scratch> scratch();

  /// `sink` is used as by write_png(). options.threads is ignored.
  PngBands(const PictureHeader& header, const PngOptions& options, std::function<void(std::string_view)> sink,
           std::shared_ptr<Scratch> scratch);
  ~PngBands();
  PngBands(const PngBands&) = delete;
  PngBands& operator=(const PngBands&) = delete;

  /// Takes the next `count` rows, which must stay in memory until the next call has returned. All strips of
  /// the band before must have been made. Rows that do not fill a strip wait for the next band.
  ///   returns   how many strips there are to make
  std::size_t next(const std::uint8_t* rows, std::size_t stride, int count);

  /// Filters and deflates strip i of the band and passes it on. Call it once for each strip, in any order and
  /// from any thread.
  void make(std::size_t i);

  /// Ends the file, after all rows have been given and all strips made.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A PNG file as write_png() makes it, in memory.
std::string png_bytes(const PngRows& image, const PngOptions& options);

/// What the chunks before the image data say about a PNG file of any form; nullopt for other files. The
/// values are not checked, except that chunks lie inside of the file. A colour profile wins over gAMA, and an
/// sRGB chunk over both.
std::optional<PictureHeader> png_header(ByteSource& bytes);

/// Throws Error when a PNG file of any form is cut short or damaged: verifies the checksums of all chunks up
/// to IEND and inflates the image data. Other libraries can then decode the file without errors.
void check_png(std::string_view bytes, std::string_view path);

}  // namespace etak
