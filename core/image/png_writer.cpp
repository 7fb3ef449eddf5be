// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <condition_variable>
#include <mutex>

#include "core/base/parallel.h"
#include "core/image/deflate.h"
#include "core/image/png.h"
#include "core/image/png_filters.h"

namespace etak {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Filtered bytes that are deflated on their own. At `fast` a strip and what it becomes stay in the
// second-level cache; the slower levels look back further and pay for each beginning.
constexpr std::size_t strip_bytes(PngLevel level) {
  return level == PngLevel::fast ? std::size_t{512} << 10 : std::size_t{2} << 20;
}

void append_big_endian(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void set_big_endian(Bytes& out, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) out[at + i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

std::string_view characters(const Bytes& bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void append_text(Bytes& out, std::string_view text) {
  out.insert(out.end(), text.begin(), text.end());
}

// Starts a chunk whose length is not known yet.
void begin_chunk(Bytes& out, std::string_view type) {
  append_big_endian(out, 0);
  append_text(out, type);
}

// Ends the chunk that began at `start` of `out`; `checksum` is that of its type and data.
void end_chunk(Bytes& out, std::size_t start, std::uint32_t checksum) {
  set_big_endian(out, start, static_cast<std::uint32_t>(out.size() - start - 8));
  append_big_endian(out, checksum);
}

void append_chunk(Bytes& out, std::string_view type, std::span<const std::uint8_t> data) {
  const std::size_t start = out.size();
  begin_chunk(out, type);
  out.insert(out.end(), data.begin(), data.end());
  end_chunk(out, start, crc32_of(0, std::span(out).subspan(start + 4)));
}

Bytes head(const PngInfo& info, bool srgb) {
  static constexpr std::array<std::uint8_t, 5> colour_type{0, 0, 4, 2, 6};  // by channels
  Bytes out;
  append_text(out, {"\x89PNG\r\n\x1a\n", 8});
  Bytes header;
  append_big_endian(header, static_cast<std::uint32_t>(info.width));
  append_big_endian(header, static_cast<std::uint32_t>(info.height));
  header.push_back(static_cast<std::uint8_t>(info.bits));
  header.push_back(colour_type[static_cast<std::size_t>(info.channels)]);
  header.insert(header.end(), {0, 0, 0});  // deflate, the five filters, not interlaced
  append_chunk(out, "IHDR", header);
  if (srgb) append_chunk(out, "sRGB", std::array<std::uint8_t, 1>{0});
  return out;
}

// What one thread works with, kept from strip to strip: two rows as the file has them with zeros before them
// and room behind, a strip of filtered rows, and the IDAT chunk made of it.
class StripWriter {
 public:
  StripWriter(const PngRows& image, PngLevel level)
      : image_(image),
        level_(level),
        pixel_(static_cast<std::size_t>(image.info.channels * image.info.bits / 8)),
        row_bytes_(static_cast<std::size_t>(image.info.width) * pixel_),
        row_(png_row_lead + row_bytes_ + png_row_slack),
        above_(row_.size()),
        deflater_(level) {}

  struct Result {
    std::uint32_t adler, checksum;
    std::size_t filtered_size;
  };

  /// Rows [begin, end) as an IDAT chunk in idat(), without its closing checksum.
  Result make(int begin, int end) {
    Result out{};
    const auto rows = static_cast<std::size_t>(end - begin);
    out.filtered_size = rows * (row_bytes_ + 1);
    filtered_.resize(out.filtered_size + png_row_slack);
    if (begin == 0)
      std::fill(above_.begin(), above_.end(), std::uint8_t{0});
    else
      copy_row(begin - 1, above_);
    std::uint8_t* at = filtered_.data();
    for (int y = begin; y < end; ++y, at += row_bytes_ + 1) {
      copy_row(y, row_);
      filters_.filter(row_.data() + png_row_lead, above_.data() + png_row_lead, row_bytes_, pixel_, at);
      row_.swap(above_);
    }
    const std::span filtered = std::span(filtered_).first(out.filtered_size);
    out.adler = adler32_of(1, filtered);
    idat_.clear();
    begin_chunk(idat_, "IDAT");
    if (begin == 0) {
      const auto header = zlib_header(level_);
      idat_.insert(idat_.end(), header.begin(), header.end());
    }
    deflater_.append(filtered, end == image_.info.height, idat_);
    out.checksum = crc32_of(0, std::span(idat_).subspan(4));
    return out;
  }

  Bytes& idat() { return idat_; }

 private:
  void copy_row(int y, Bytes& to) const {
    const std::uint8_t* from = image_.rows + static_cast<std::size_t>(y) * image_.stride;
    std::uint8_t* out = to.data() + png_row_lead;
    if (image_.info.bits == 8 || std::endian::native == std::endian::big) {
      std::copy_n(from, row_bytes_, out);
      return;
    }
    for (std::size_t i = 0; i < row_bytes_; i += 2) {
      out[i] = from[i + 1];
      out[i + 1] = from[i];
    }
  }

  const PngRows& image_;
  PngLevel level_;
  std::size_t pixel_, row_bytes_;
  Bytes row_, above_, filtered_, idat_;
  Deflater deflater_;
  const PngFilters& filters_ = png_filters();
};

// Lets threads pass one at a time and in the order of their numbers.
class Turnstile {
 public:
  /// False when another thread has failed, and the turn will never come.
  bool wait(std::size_t number) {
    std::unique_lock lock(lock_);
    moved_.wait(lock, [&] { return next_ == number || failed_; });
    return !failed_;
  }
  void passed() {
    const std::lock_guard lock(lock_);
    ++next_;
    moved_.notify_all();
  }
  void fail() {
    const std::lock_guard lock(lock_);
    failed_ = true;
    moved_.notify_all();
  }

 private:
  std::mutex lock_;
  std::condition_variable moved_;
  std::size_t next_ = 0;
  bool failed_ = false;
};

}  // namespace

void write_png(const PngRows& image, const PngOptions& options,
               const std::function<void(std::string_view)>& sink) {
  const PngInfo& info = image.info;
  assert(info.width >= 1 && info.height >= 1 && info.channels >= 1 && info.channels <= 4);
  assert(info.bits == 8 || info.bits == 16);
  sink(characters(head(info, options.srgb)));
  const std::size_t row =
      static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.channels * info.bits / 8) + 1;
  const auto height = static_cast<std::size_t>(info.height);
  const std::size_t rows = std::clamp<std::size_t>(strip_bytes(options.level) / row, 1, height);
  const std::size_t strips = (height + rows - 1) / rows;

  Turnstile turnstile;
  std::uint32_t adler = 1;
  std::vector<std::unique_ptr<StripWriter>> workers(std::max(1u, options.threads));
  parallel_chunks(strips, options.threads, 1, [&](std::size_t strip, std::size_t, unsigned worker) {
    try {
      auto& mine = workers[worker];
      if (!mine) mine = std::make_unique<StripWriter>(image, options.level);
      const auto begin = strip * rows, end = std::min(height, begin + rows);
      StripWriter::Result made = mine->make(static_cast<int>(begin), static_cast<int>(end));
      if (!turnstile.wait(strip)) return;
      adler = strip == 0 ? made.adler : adler32_of_both(adler, made.adler, made.filtered_size);
      Bytes& idat = mine->idat();
      if (strip + 1 == strips) {
        append_big_endian(idat, adler);
        made.checksum = crc32_of(made.checksum, std::span(idat).last(4));
      }
      end_chunk(idat, 0, made.checksum);
      sink(characters(idat));
      turnstile.passed();
    } catch (...) {
      turnstile.fail();
      throw;
    }
  });
  Bytes tail;
  append_chunk(tail, "IEND", {});
  sink(characters(tail));
}

std::string png_bytes(const PngRows& image, const PngOptions& options) {
  std::string out;
  write_png(image, options, [&](std::string_view piece) { out.append(piece); });
  return out;
}

}  // namespace etak
