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

// PNG (ISO/IEC 15948), where the time of an atlas goes, without OpenImageIO: ISA-L inflates and deflates
// where it was found when etak was built, zlib elsewhere. Only what etak's textures are made of: 8 and 16
// bits, grey, grey + alpha, RGB, RGBA, not interlaced; colour is never multiplied by the last channel.
// Everything else (palette, 1-4 bits, Adam7, tRNS) is the business of image_io.h.

/// Reads rows from the top, in strips, so that no more than a strip needs to be held. Stricter than the
/// standard asks of decoders, and than libpng is: a texture that is damaged anywhere is refused. Beyond what
/// libpng refuses these are errors: a wrong checksum of any chunk or of the image data, image data that goes
/// on behind the last row, IDAT chunks with others between them, a PLTE chunk where no colour can use it, an
/// IEND chunk with content. Bytes behind IEND are not looked at.
/// One thing that libpng refuses is read: a zlib header with a smaller window than the stream needs (the
/// checksum shows that the pixels are right).
class PngReader {
 public:
  /// nullopt: not a PNG, or one of the forms above that are not read here.
  ///   bytes   of the whole file; must outlive the reader
  ///   path    for messages
  /// Throws Error for a PNG of ours that is broken: bad chunk, checksum, size above max_image_side.
  static std::optional<PngReader> open(std::string_view bytes, std::string_view path);
  /// The same of a file that is read as its rows are asked for; it must outlive the reader.
  static std::optional<PngReader> open(ByteSource& file, std::string_view path);
  PngReader(PngReader&&) noexcept;
  PngReader& operator=(PngReader&&) noexcept;
  ~PngReader();

  const PictureHeader& header() const;

  /// The next `count` rows (fewer than that left is the caller's mistake) to `out`, row i at out + i *
  /// stride; 16-bit samples in the machine's byte order. After the last row the stream's end and checksum are
  /// looked at. Throws Error for truncated or damaged data.
  void read_rows(std::uint8_t* out, std::size_t stride, int count);

 private:
  friend void check_png(std::string_view bytes, std::string_view path);
  struct State;
  explicit PngReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Rows of codes in memory, `stride` bytes apart; samples of 16 bits in the machine's byte order. Of the
/// header the sides, channels (1 grey, 2 grey + alpha, 3 RGB, 4 RGBA) and bits count: 8 or 16, or of one
/// channel 1, 2 or 4, the first code of a row in the highest bits of a byte.
struct PngRows {
  PictureHeader header;
  const std::uint8_t* rows = nullptr;
  std::size_t stride = 0;

  PngRows(PictureHeader header_, const std::uint8_t* rows_, std::size_t stride_)
      : header(std::move(header_)), rows(rows_), stride(stride_) {}
  /// Of a whole picture, which stays as long as this.
  template <class Code>
  PngRows(const Pixels<Code>& image)
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
      : PngRows(header_of(image), reinterpret_cast<const std::uint8_t*>(image.values.data()),
                static_cast<std::size_t>(image.width * image.channels) * sizeof(Code)) {}
};

/// How hard to compress. What a level means is fixed for one build of etak, and so are the bytes for any
/// thread count.
/// Row filters are chosen by least sum of absolute differences at every level; rows of a palette's codes and
/// of fewer than 8 bits are not filtered.
///   fast       the default: ISA-L level 1 (without it zlib's RLE strategy)
///   small      zlib level 6
///   smallest   zlib level 9
enum class PngLevel { fast, small, smallest };

/// RGBA; those whose alpha is not 255 come first.
using PngPalette = std::vector<std::array<std::uint8_t, 4>>;

struct PngOptions {
  PngLevel level = PngLevel::fast;
  unsigned threads = 1;
  bool srgb = false;        // write an sRGB chunk (perceptual intent)
  PngPalette palette = {};  // not empty: the rows hold codes of it, of one channel and up to 8 bits
};

/// A PNG file, piece by piece and in order to `sink`, which is called by one thread at a time; strips of rows
/// are filtered and deflated side by side, as many at once as there are threads. What `sink` throws comes
/// out.
void write_png(const PngRows& image, const PngOptions& options,
               const std::function<void(std::string_view)>& sink);

/// A PNG file whose rows come in bands from the top, for pictures that are never whole in memory; bytes as
/// write_png()'s. A band is made of strips, which threads of the caller's may make side by side.
class PngBands {
 public:
  /// What threads work with; writers that share one hold no more of it than there are threads.
  class Scratch;
  static std::shared_ptr<Scratch> scratch();

  /// `sink` as of write_png(); options.threads is not looked at.
  PngBands(const PictureHeader& header, const PngOptions& options, std::function<void(std::string_view)> sink,
           std::shared_ptr<Scratch> scratch);
  ~PngBands();
  PngBands(const PngBands&) = delete;
  PngBands& operator=(const PngBands&) = delete;

  /// The next `count` rows, which stay where they are until the next call has returned; how many strips they
  /// make (rows that fill none wait for the next band). The strips of the band before must be made.
  std::size_t next(const std::uint8_t* rows, std::size_t stride, int count);

  /// Filters, deflates and hands on strip i of the band; each once, in any order and by any threads.
  void make(std::size_t i);

  /// Ends the file when all rows are there and made.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same in memory.
std::string png_bytes(const PngRows& image, const PngOptions& options);

/// What the chunks before the image data of a PNG file say, whatever its form; nothing is trusted but lengths
/// that fit. An sRGB chunk wins over gAMA, as the standard says. nullopt for other files.
std::optional<PictureHeader> png_header(ByteSource& bytes);

/// Throws Error when a PNG file of any form is cut short or damaged: goes through its chunks up to IEND and
/// their checksums, and inflates its image data. Decoders of others then have nothing left to complain of.
void check_png(std::string_view bytes, std::string_view path);

}  // namespace etak
