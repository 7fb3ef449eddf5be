// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <condition_variable>
#include <map>
#include <mutex>

#include "core/base/parallel.h"
#include "core/image/files/deflate.h"
#include "core/image/files/png.h"
#include "core/image/files/png_chunks.h"
#include "core/image/files/png_filters.h"
#include "core/image/files/png_strips.h"

namespace etak {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Size of a strip: how many filtered bytes are deflated on their own. At level `fast`, a strip and its
// deflated form stay in the second-level cache. The slower levels find matches further back, and lose some at
// the start of each strip, so their strips are larger.
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

// Ends the chunk that began at offset `start` of `out`; `checksum` is the CRC-32 of its type and data.
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

std::size_t bytes_of_row(const PictureHeader& info) {
  const auto codes = static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.channels);
  return (codes * static_cast<std::size_t>(info.bits) + 7) / 8;
}

Bytes head(const PictureHeader& info, const PngOptions& options) {
  static constexpr std::array<std::uint8_t, 5> colour_type{0, 0, 4, 2, 6};  // by the number of channels
  Bytes out;
  append_text(out, png_signature);
  Bytes header;
  append_big_endian(header, static_cast<std::uint32_t>(info.width));
  append_big_endian(header, static_cast<std::uint32_t>(info.height));
  header.push_back(static_cast<std::uint8_t>(info.bits));
  constexpr std::uint8_t indexed = 3;
  header.push_back(options.palette.empty() ? colour_type[static_cast<std::size_t>(info.channels)] : indexed);
  header.insert(header.end(), {0, 0, 0});  // deflate, the five filters, not interlaced
  append_chunk(out, "IHDR", header);
  if (options.srgb) append_chunk(out, "sRGB", std::array<std::uint8_t, 1>{0});
  if (options.palette.empty()) return out;
  Bytes colours, alphas;
  for (const auto& [red, green, blue, alpha] : options.palette) {
    colours.insert(colours.end(), {red, green, blue});
    if (alpha != 255) alphas.push_back(alpha);
  }
  append_chunk(out, "PLTE", colours);
  if (!alphas.empty()) append_chunk(out, "tRNS", alphas);
  return out;
}

// The buffers of one thread, kept from strip to strip: two rows in the byte order of the file, with zeros in
// front and room behind; and a strip of filtered rows.
struct Tools {
  explicit Tools(PngLevel level) : deflater(level) {}
  Bytes row, above, filtered, idat;
  Deflater deflater;
};

// A finished strip that waits for the strips before it.
struct Strip {
  Bytes idat;
  std::uint32_t adler = 1, checksum = 0;
  std::size_t filtered_size = 0;
};

}  // namespace

class PngBands::Scratch {
 public:
  std::unique_ptr<Tools> take(PngLevel level) {
    {
      const std::lock_guard lock(lock_);
      auto& free = free_[static_cast<std::size_t>(level)];
      if (!free.empty()) {
        std::unique_ptr<Tools> out = std::move(free.back());
        free.pop_back();
        return out;
      }
    }
    return std::make_unique<Tools>(level);
  }
  void give_back(std::unique_ptr<Tools> tools, PngLevel level) {
    const std::lock_guard lock(lock_);
    free_[static_cast<std::size_t>(level)].push_back(std::move(tools));
  }
  Bytes take_bytes() {
    const std::lock_guard lock(lock_);
    if (bytes_.empty()) return {};
    Bytes out = std::move(bytes_.back());
    bytes_.pop_back();
    return out;
  }
  void give_back(Bytes bytes) {
    const std::lock_guard lock(lock_);
    bytes_.push_back(std::move(bytes));
  }

 private:
  std::mutex lock_;
  std::array<std::vector<std::unique_ptr<Tools>>, 3> free_;
  std::vector<Bytes> bytes_;
};

struct PngBands::State {
  static constexpr std::size_t most_waiting = 16;

  PictureHeader info;
  PngOptions options;
  std::function<void(std::string_view)> sink;
  std::shared_ptr<Scratch> scratch;
  std::size_t pixel = 0, row_bytes = 0;
  bool filtered_rows = true;
  int strip_rows = 1;
  const PngFilters& filters = png_filters();

  // The band is the rows [first, end) of the picture. Rows before `split` are in `carried`, the others at
  // `rows`. The first row of `carried` is the one above the band (zeros above the first row of the picture).
  int first = 0, split = 0, end = 0;
  Bytes carried;
  const std::uint8_t* rows = nullptr;
  std::size_t stride = 0;

  std::mutex lock;                       // guards the members below
  std::map<std::size_t, Strip> waiting;  // finished strips, by their number in the file
  std::size_t next_strip = 0;
  std::uint32_t adler = 1;
  bool handing_on = false, failed = false;
  std::condition_variable moved;

  const std::uint8_t* row(int y) const {
    if (y < split) return carried.data() + static_cast<std::size_t>(y - first + 1) * row_bytes;
    return rows + static_cast<std::size_t>(y - split) * stride;
  }

  // Copies a row, with its samples in the byte order of the file.
  void copy_row(int y, Bytes& to) const {
    const std::uint8_t* from = row(y);
    std::uint8_t* out = to.data() + png_row_lead;
    if (info.bits != 16 || std::endian::native == std::endian::big) {
      std::copy_n(from, row_bytes, out);
      return;
    }
    for (std::size_t i = 0; i < row_bytes; i += 2) {
      out[i] = from[i + 1];
      out[i + 1] = from[i];
    }
  }

  // Makes the IDAT chunk of rows [begin, stop), without the checksum at its end.
  Strip deflated(int begin, int stop, Tools& tools) const {
    Strip out;
    out.filtered_size = static_cast<std::size_t>(stop - begin) * (row_bytes + 1);
    const std::size_t padded = png_row_lead + row_bytes + png_row_slack;
    if (tools.filtered.size() < out.filtered_size + png_row_slack)
      tools.filtered.resize(out.filtered_size + png_row_slack);
    tools.row.resize(padded);
    tools.above.resize(padded);
    std::fill_n(tools.row.begin(), png_row_lead, std::uint8_t{0});
    std::fill_n(tools.above.begin(), png_row_lead, std::uint8_t{0});
    copy_row(begin - 1, tools.above);
    std::uint8_t* at = tools.filtered.data();
    for (int y = begin; y < stop; ++y, at += row_bytes + 1) {
      copy_row(y, tools.row);
      if (filtered_rows) {
        filters.filter(tools.row.data() + png_row_lead, tools.above.data() + png_row_lead, row_bytes, pixel,
                       at);
      } else {
        *at = 0;
        std::copy_n(tools.row.data() + png_row_lead, row_bytes, at + 1);
      }
      tools.row.swap(tools.above);
    }
    const std::span filtered = std::span(tools.filtered).first(out.filtered_size);
    out.adler = adler32_of(1, filtered);
    out.idat = scratch->take_bytes();
    out.idat.clear();
    begin_chunk(out.idat, "IDAT");
    if (begin == 0) {
      const auto header = zlib_header(options.level);
      out.idat.insert(out.idat.end(), header.begin(), header.end());
    }
    tools.deflater.append(filtered, stop == info.height, out.idat);
    out.checksum = crc32_of(0, std::span(out.idat).subspan(4));
    return out;
  }

  // Passes on the strips whose turn has come. One thread at a time does so; the others leave their strips to
  // it.
  void hand_on(std::size_t number, Strip strip) {
    std::unique_lock guard(lock);
    // The number of waiting strips is limited, in case the disk is slow.
    moved.wait(guard, [&] { return failed || number == next_strip || waiting.size() < most_waiting; });
    if (failed) return;
    waiting.emplace(number, std::move(strip));
    if (handing_on) return;
    handing_on = true;
    while (!waiting.empty() && waiting.begin()->first == next_strip) {
      Strip now = std::move(waiting.begin()->second);
      waiting.erase(waiting.begin());
      guard.unlock();
      adler = next_strip == 0 ? now.adler : adler32_of_both(adler, now.adler, now.filtered_size);
      if (static_cast<int>(next_strip + 1) * strip_rows >= info.height) {
        append_big_endian(now.idat, adler);
        now.checksum = crc32_of(now.checksum, std::span(now.idat).last(4));
      }
      end_chunk(now.idat, 0, now.checksum);
      sink(characters(now.idat));
      scratch->give_back(std::move(now.idat));
      guard.lock();
      ++next_strip;
      moved.notify_all();
    }
    handing_on = false;
  }
};

std::shared_ptr<PngBands::Scratch> PngBands::scratch() {
  return std::make_shared<Scratch>();
}

PngBands::PngBands(const PictureHeader& info, const PngOptions& options,
                   std::function<void(std::string_view)> sink, std::shared_ptr<Scratch> scratch)
    : state_(std::make_unique<State>()) {
  assert(info.width >= 1 && info.height >= 1 && info.channels >= 1 && info.channels <= 4);
  assert(info.bits == 8 || info.bits == 16 || (info.channels == 1 && info.bits < 8));
  assert(options.palette.empty() || (info.channels == 1 && info.bits <= 8));
  State& s = *state_;
  s.info = info;
  s.options = options;
  s.sink = std::move(sink);
  s.scratch = std::move(scratch);
  s.pixel = static_cast<std::size_t>(info.channels * info.bits / 8);
  s.row_bytes = bytes_of_row(info);
  s.filtered_rows = info.bits >= 8 && options.palette.empty();
  s.strip_rows = png_strip_rows(info, options.level);
  s.carried.resize(s.row_bytes);
  s.sink(characters(head(info, options)));
}

PngBands::~PngBands() = default;

std::size_t PngBands::next(const std::uint8_t* rows, std::size_t stride, int count) {
  State& s = *state_;
  assert(count >= 0 && s.end + count <= s.info.height);
  // Rows of the old band that no strip has used, and the row above them, are carried over to the new band.
  const int taken = s.end == s.info.height ? s.end : s.end / s.strip_rows * s.strip_rows;
  Bytes carried(static_cast<std::size_t>(s.end - taken + 1) * s.row_bytes);
  for (int y = std::max(taken - 1, 0); y < s.end; ++y)
    std::copy_n(s.row(y), s.row_bytes,
                carried.data() + static_cast<std::size_t>(y - taken + 1) * s.row_bytes);
  s.carried.swap(carried);
  s.first = taken;
  s.split = s.end;
  s.end += count;
  s.rows = rows;
  s.stride = stride;
  const int whole = s.end == s.info.height ? s.end - s.first + s.strip_rows - 1 : s.end - s.first;
  return static_cast<std::size_t>(whole / s.strip_rows);
}

void PngBands::make(std::size_t i) {
  State& s = *state_;
  const int begin = s.first + static_cast<int>(i) * s.strip_rows;
  const int stop = std::min(s.info.height, begin + s.strip_rows);
  try {
    std::unique_ptr<Tools> tools = s.scratch->take(s.options.level);
    Strip strip = s.deflated(begin, stop, *tools);
    s.scratch->give_back(std::move(tools), s.options.level);
    s.hand_on(static_cast<std::size_t>(begin / s.strip_rows), std::move(strip));
  } catch (...) {
    const std::lock_guard lock(s.lock);
    s.failed = true;
    s.moved.notify_all();
    throw;
  }
}

void PngBands::finish() {
  assert(state_->end == state_->info.height && state_->waiting.empty());
  Bytes tail;
  append_chunk(tail, "IEND", {});
  state_->sink(characters(tail));
}

int png_strip_rows(const PictureHeader& info, PngLevel level) {
  return static_cast<int>(std::clamp<std::size_t>(strip_bytes(level) / (bytes_of_row(info) + 1), 1,
                                                  static_cast<std::size_t>(info.height)));
}

void write_png(const PngRows& image, const PngOptions& options,
               const std::function<void(std::string_view)>& sink) {
  PngBands bands(image.header, options, sink, PngBands::scratch());
  const std::size_t strips = bands.next(image.rows, image.stride, image.header.height);
  parallel_chunks(strips, options.threads, 1,
                  [&](std::size_t strip, std::size_t, unsigned) { bands.make(strip); });
  bands.finish();
}

std::string png_bytes(const PngRows& image, const PngOptions& options) {
  std::string out;
  write_png(image, options, [&](std::string_view piece) { out.append(piece); });
  return out;
}

}  // namespace etak
