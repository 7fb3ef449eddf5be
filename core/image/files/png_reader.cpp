// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <span>

#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/image/files/deflate.h"
#include "core/image/files/png.h"
#include "core/image/files/png_chunks.h"
#include "core/image/files/png_filters.h"

namespace etak {
namespace {

constexpr std::size_t deflate_at_most = 1032;  // bytes that one byte of a deflate stream can inflate to

// Sizes of the buffers, small enough to stay in the second-level cache between inflating and unfiltering.
constexpr std::size_t input_bytes = std::size_t{64} << 10;
constexpr std::size_t filtered_bytes = std::size_t{256} << 10;

bool valid(const PngForm& h) {
  const bool depth = h.bits == 8 || (h.bits == 16 && h.colour != 3) ||
                     ((h.bits == 1 || h.bits == 2 || h.bits == 4) && (h.colour == 0 || h.colour == 3));
  return png_channels(h.colour) != 0 && depth && h.compression == 0 && h.filter == 0 && h.interlace <= 1;
}

}  // namespace

struct PngReader::State {
  std::unique_ptr<ByteSource> own;  // owns `bytes` where the file is in memory
  ByteSource* bytes = nullptr;
  std::string path;
  PictureHeader info;
  std::size_t row_bytes = 0;
  int rows_done = 0;

  // The IDAT chunk that is being read, and how many of its bytes the inflater has got.
  PngChunk idat;
  std::size_t idat_taken = 0;
  std::uint32_t idat_checksum = 0;
  bool idat_over = false;
  std::vector<std::uint8_t> input;
  Inflater inflater;

  // Inflated rows that are not unfiltered yet: the bytes [filtered_used, filtered_end) of `filtered`.
  // `data_left` bytes are still to be inflated.
  std::vector<std::uint8_t> filtered;
  std::size_t filtered_used = 0, filtered_end = 0, data_left = 0;
  std::vector<std::uint8_t> above;                // the last finished row, in the byte order of the file
  std::array<std::vector<std::uint8_t>, 2> wide;  // finished rows of 16 bits, in the byte order of the file
  const PngFilters* filters = &png_filters();

  [[noreturn]] void fail(const std::string& found, std::string_view expected = "an undamaged PNG") const {
    throw Error::at(path, found, expected);
  }
  [[noreturn]] void fail(const PngChunk& chunk, const char* what) const {
    fail("PNG chunk " + printable(chunk.type) + " at byte " + std::to_string(chunk.start) + " " + what);
  }

  PngChunk next_chunk(std::size_t start) const;
  PngChunk checked_chunk(std::size_t start) const;
  PngForm form() const;
  bool read_header();
  bool read_until_idat();
  void begin_idat(const PngChunk& chunk);
  void end_idat();
  void gather_input();
  void fill();
  void finish();
  void finish_chunks();
  void check_rows(std::size_t rows, std::size_t length);
  void find_end();
};

PngChunk PngReader::State::next_chunk(std::size_t start) const {
  const std::optional<PngChunk> chunk = png_chunk_at(*bytes, start);
  if (!chunk)
    fail("ends at byte " + std::to_string(bytes->size()) + ", in the PNG chunk that begins at byte " +
         std::to_string(std::min(start, bytes->size())));
  for (const char c : chunk->type)
    if (const int letter = c & ~32; letter < 'A' || letter > 'Z') fail(*chunk, "has no valid type");
  return *chunk;
}

PngChunk PngReader::State::checked_chunk(std::size_t start) const {
  const PngChunk chunk = next_chunk(start);
  if (chunk.type != "IDAT" && checksum(*bytes, chunk) != stored_checksum(*bytes, chunk))
    fail(chunk, "has a wrong checksum");
  return chunk;
}

PngForm PngReader::State::form() const {
  const PngChunk chunk = checked_chunk(png_signature.size());
  if (chunk.type != "IHDR") fail(chunk, "comes first, where IHDR belongs");
  if (chunk.size != 13) fail(chunk, "is not 13 bytes long");
  const PngForm h = png_form(bytes->view(chunk.data(), chunk.size));
  if (!valid(h))
    fail("PNG header with bit depth " + std::to_string(h.bits) + ", colour type " + std::to_string(h.colour) +
             ", compression " + std::to_string(h.compression) + ", filter " + std::to_string(h.filter) +
             ", interlacing " + std::to_string(h.interlace),
         "a combination that PNG has");
  if (h.width < 1 || h.height < 1 || h.width > max_image_side || h.height > max_image_side)
    fail("is " + std::to_string(h.width) + " x " + std::to_string(h.height) + " pixels",
         "1 to " + std::to_string(max_image_side) + " on a side");
  return h;
}

// Reads the IHDR chunk; false for forms that PngReader does not read.
bool PngReader::State::read_header() {
  const PngForm h = form();
  info = *png_header(*bytes);
  if (!info.strips) return false;
  row_bytes = std::size_t{h.width} * static_cast<std::size_t>(info.channels * info.bits / 8);
  data_left = (row_bytes + 1) * h.height;
  // Checked before memory is allocated: no deflate stream of this length can hold that much.
  if (data_left / deflate_at_most > bytes->size())
    fail("holds " + std::to_string(bytes->size()) + " bytes, too few for its " + std::to_string(h.width) +
         " x " + std::to_string(h.height) + " pixels");
  return true;
}

bool PngReader::State::read_until_idat() {
  bool palette = false;
  for (std::size_t at = png_signature.size() + png_chunk_overhead + 13;;) {
    const PngChunk chunk = checked_chunk(at);
    if (chunk.type == "IDAT") {
      begin_idat(chunk);
      return true;
    }
    if (chunk.type == "tRNS") return false;
    if (chunk.type == "PLTE") {
      // In RGB and RGBA pictures, PLTE is a palette suggested for displays of few colours.
      if (palette || info.channels < 3 || chunk.size % 3 != 0 || chunk.size > 768)
        fail(chunk, "is no palette that belongs here");
      palette = true;
    } else if (chunk.critical()) {
      fail(chunk, "is one that etak does not know or expect here, and no decoder may skip it");
    }
    at = chunk.end();
  }
}

void PngReader::State::begin_idat(const PngChunk& chunk) {
  idat = chunk;
  idat_taken = 0;
  idat_checksum = crc32_of(0, octets(chunk.type));
}

// Checks the checksum of the IDAT chunk, and begins the next one where another follows.
void PngReader::State::end_idat() {
  if (idat_checksum != stored_checksum(*bytes, idat)) fail(idat, "has a wrong checksum");
  const PngChunk next = checked_chunk(idat.end());
  if (next.type == "IDAT")
    begin_idat(next);
  else
    idat_over = true;
}

// Gives the inflater the data of as many chunks as fit into the buffer, because files with an IDAT chunk for
// every few bytes are common.
void PngReader::State::gather_input() {
  std::size_t size = 0;
  while (size < input.size() && !idat_over) {
    const std::size_t take = std::min(input.size() - size, idat.size - idat_taken);
    std::copy_n(octets(bytes->view(idat.data() + idat_taken, take)).data(), take, input.data() + size);
    idat_checksum = crc32_of(idat_checksum, std::span(input).subspan(size, take));
    size += take;
    idat_taken += take;
    if (idat_taken < idat.size) break;
    end_idat();
  }
  inflater.feed(std::span(input).first(size));
}

// Inflates at least until a whole row is in `filtered`, and as much more as there is room for.
void PngReader::State::fill() {
  std::copy(filtered.data() + filtered_used, filtered.data() + filtered_end, filtered.data());
  filtered_end -= filtered_used;
  filtered_used = 0;
  const std::size_t room = filtered.size() - png_row_slack;
  while (filtered_end <= row_bytes || (data_left > 0 && filtered_end < room)) {
    std::size_t written = 0;
    const std::size_t wanted = std::min(data_left, room - filtered_end);
    const Inflater::Status status = inflater.read(std::span(filtered).subspan(filtered_end, wanted), written);
    filtered_end += written;
    data_left -= written;
    if (status == Inflater::Status::damaged) fail(std::string("image data is damaged: ") + inflater.what());
    if (status == Inflater::Status::ended && data_left > 0)
      fail("image data ends before the last of its " + std::to_string(info.height) + " rows");
    if (status == Inflater::Status::ended) return;
    if (status == Inflater::Status::hungry) {
      if (idat_over) fail("image data is cut short");
      gather_input();
    }
  }
}

// Checks, after the last row, that the stream ends with its checksum and that no image data follow.
void PngReader::State::finish() {
  std::array<std::uint8_t, 1> more;
  for (Inflater::Status status{}; status != Inflater::Status::ended;) {
    std::size_t written = 0;
    status = inflater.read(more, written);
    if (status == Inflater::Status::damaged)
      fail(std::string("image data is damaged behind its last row: ") + inflater.what());
    if (written > 0)
      fail("image data goes on behind the last of its " + std::to_string(info.height) + " rows");
    if (status == Inflater::Status::hungry) {
      if (idat_over) fail("image data has no end");
      gather_input();
    }
  }
  if (inflater.unused() > 0) fail("image data goes on behind its end");
  finish_chunks();
}

void PngReader::State::finish_chunks() {
  // Only empty chunks of image data may be left.
  while (!idat_over) {
    if (idat_taken < idat.size) fail("image data goes on behind its end");
    end_idat();
  }
  for (std::size_t at = idat.end();;) {
    const PngChunk chunk = checked_chunk(at);
    if (chunk.type == "IEND") {
      if (chunk.size != 0) fail(chunk, "is not empty");
      return;
    }
    if (chunk.critical()) fail(chunk, "has no place behind the image data");
    at = chunk.end();
  }
}

// Inflates `rows` rows of `length` bytes each, in front of which is the number of their filter, and checks
// that number.
void PngReader::State::check_rows(std::size_t rows, std::size_t length) {
  std::size_t in_row = 0;
  for (std::size_t row = 0; row < rows;) {
    std::size_t written = 0;
    const std::size_t room = std::min(filtered.size(), length + 1 - in_row);
    const Inflater::Status status = inflater.read(std::span(filtered).first(room), written);
    if (written > 0 && in_row == 0 && filtered[0] > 4)
      fail("a row of its image data has filter " + std::to_string(int{filtered[0]}), "0 to 4");
    in_row += written;
    if (in_row > length) {
      in_row = 0;
      ++row;
    }
    if (status == Inflater::Status::damaged) fail(std::string("image data is damaged: ") + inflater.what());
    if (status == Inflater::Status::ended) {
      if (row < rows) fail("image data ends before the last of its rows");
      return;
    }
    if (status == Inflater::Status::hungry && row < rows) {
      if (idat_over) fail("image data is cut short");
      gather_input();
    }
  }
}

// Looks for the end of the stream behind the last row. Other decoders accept more data there, and a wrong
// checksum, so these are no errors here. Only a little of such data is read, since a small file may hold
// gigabytes of it.
void PngReader::State::find_end() {
  constexpr std::size_t enough = 1024;
  for (std::size_t more = 0; more < enough;) {
    std::size_t written = 0;
    const Inflater::Status status = inflater.read(std::span(filtered).first(enough), written);
    more += written;
    if (status == Inflater::Status::ended || status == Inflater::Status::damaged) return;
    if (status != Inflater::Status::hungry) continue;
    if (idat_over) fail("image data has no end");
    gather_input();
  }
}

std::optional<PngReader> PngReader::open(std::string_view bytes, std::string_view path) {
  auto own = std::make_unique<BytesInMemory>(bytes);
  std::optional<PngReader> out = open(*own, path);
  if (out) out->state_->own = std::move(own);
  return out;
}

std::optional<PngReader> PngReader::open(ByteSource& bytes, std::string_view path) {
  if (!has_png_signature(bytes)) return std::nullopt;
  auto state = std::make_unique<State>();
  state->bytes = &bytes;
  state->path = path;
  if (!state->read_header() || !state->read_until_idat()) return std::nullopt;
  const std::size_t row = state->row_bytes + 1;
  state->input.resize(std::min(input_bytes, bytes.size()));
  state->filtered.resize(std::min(std::max(filtered_bytes, row), state->data_left) + png_row_slack);
  state->above.resize(state->row_bytes);
  if (state->info.bits == 16)
    for (auto& wide : state->wide) wide.resize(state->row_bytes);
  return PngReader(std::move(state));
}

PngReader::PngReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
PngReader::PngReader(PngReader&&) noexcept = default;
PngReader& PngReader::operator=(PngReader&&) noexcept = default;
PngReader::~PngReader() = default;

const PictureHeader& PngReader::header() const {
  return state_->info;
}

void PngReader::read_rows(std::uint8_t* out, std::size_t stride, int count) {
  State& s = *state_;
  assert(count >= 0 && count <= s.info.height - s.rows_done);
  if (count == 0) return;
  const std::size_t pixel = s.row_bytes / static_cast<std::size_t>(s.info.width);
  const std::uint8_t* above = s.above.data();
  for (int i = 0; i < count; ++i, out += stride) {
    if (s.filtered_end - s.filtered_used <= s.row_bytes) s.fill();
    const std::uint8_t* row = s.filtered.data() + s.filtered_used;
    s.filtered_used += s.row_bytes + 1;
    if (*row > 4)
      s.fail("row " + std::to_string(s.rows_done) + " has filter " + std::to_string(int{*row}), "0 to 4");
    std::uint8_t* finished =
        s.info.bits == 8 ? out : s.wide[static_cast<std::size_t>(s.rows_done & 1)].data();
    s.filters->unfilter(*row, row + 1, above, s.row_bytes, pixel, finished);
    if (s.info.bits == 16) {
      if constexpr (std::endian::native == std::endian::little)
        for (std::size_t k = 0; k < s.row_bytes; k += 2) {
          out[k] = finished[k + 1];
          out[k + 1] = finished[k];
        }
      else
        std::copy_n(finished, s.row_bytes, out);
    }
    above = finished;
    ++s.rows_done;
  }
  // The row is copied, because the caller may change the rows that it was given.
  std::copy_n(above, s.row_bytes, s.above.data());
  if (s.rows_done == s.info.height) s.finish();
}

void check_png(std::string_view in_memory, std::string_view path) {
  BytesInMemory bytes(in_memory);
  PngReader::State s;
  s.bytes = &bytes;
  s.path = path;
  bool image = false;
  for (std::size_t at = png_signature.size();;) {
    if (!png_chunk_at(bytes, at)) throw Error::at(path, "is cut short", "a whole picture file");
    const PngChunk chunk = s.next_chunk(at);
    if (checksum(bytes, chunk) != stored_checksum(bytes, chunk)) s.fail(chunk, "has a wrong checksum");
    if (chunk.type == "IEND") break;
    if (image && chunk.critical() && chunk.type != "IDAT")
      s.fail(chunk, "has no place behind the image data");
    image |= chunk.type == "IDAT";
    at = chunk.end();
  }
  const PngForm h = s.form();
  bool palette = false;
  std::size_t at = png_signature.size() + png_chunk_overhead + 13;
  for (PngChunk chunk = s.checked_chunk(at); chunk.type != "IDAT"; chunk = s.checked_chunk(at)) {
    if (chunk.type == "IEND") s.fail("holds no image data");
    if (chunk.type == "PLTE") {
      const bool sized = chunk.size % 3 == 0 && chunk.size > 0 && chunk.size <= 768;
      if (palette || (h.colour == 3 && !sized)) s.fail(chunk, "is no palette that belongs here");
      palette = true;
    } else if (chunk.critical()) {
      s.fail(chunk, "is one that etak does not know or expect here, and no decoder may skip it");
    }
    at = chunk.end();
  }
  if (h.colour == 3 && !palette) s.fail("holds codes of a palette before any palette");
  s.begin_idat(s.next_chunk(at));
  s.input.resize(std::min(input_bytes, bytes.size()));
  s.filtered.resize(filtered_bytes);
  // The first column and row of each pass, and the steps between its columns and rows. Interlaced pictures
  // have the first seven passes; others have only the last one.
  struct Pass {
    std::uint32_t x, y, dx, dy;
  };
  constexpr std::array<Pass, 8> passes{{{0, 0, 8, 8},
                                        {4, 0, 8, 8},
                                        {0, 4, 4, 8},
                                        {2, 0, 4, 4},
                                        {0, 2, 2, 4},
                                        {1, 0, 2, 2},
                                        {0, 1, 1, 2},
                                        {0, 0, 1, 1}}};
  const auto bits = static_cast<std::size_t>(png_channels(h.colour) * h.bits);
  for (const Pass& pass : h.interlace != 0 ? std::span(passes).first(7) : std::span(passes).last(1)) {
    if (pass.x >= h.width || pass.y >= h.height) continue;
    const std::size_t columns = (h.width - pass.x + pass.dx - 1) / pass.dx;
    s.check_rows((h.height - pass.y + pass.dy - 1) / pass.dy, (columns * bits + 7) / 8);
  }
  s.find_end();
}

}  // namespace etak
