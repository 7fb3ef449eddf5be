// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/deflate.h"

#include <zlib.h>
#ifdef ETAK_HAS_ISAL
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <new>

namespace etak {
namespace {

#ifndef ETAK_HAS_ISAL
constexpr std::size_t most_at_once = std::size_t{1} << 30;  // zlib counts in 32 bits
#endif

int zlib_level(PngLevel level) {
  return level == PngLevel::fast ? 1 : level == PngLevel::small ? 6 : 9;
}

// Makes room for `wanted` bytes behind the first `used` bytes of `out`; returns how much room there is, at
// most 1 GiB.
std::uint32_t make_room(std::vector<std::uint8_t>& out, std::size_t used, std::size_t wanted) {
  if (out.size() < used + wanted) out.resize(used + wanted);
  return static_cast<std::uint32_t>(std::min<std::size_t>(out.size() - used, std::size_t{1} << 30));
}

}  // namespace

std::uint32_t crc32_of(std::uint32_t crc, std::span<const std::uint8_t> bytes) {
#ifdef ETAK_HAS_ISAL
  return ::crc32_gzip_refl(crc, bytes.data(), bytes.size());
#else
  return static_cast<std::uint32_t>(::crc32_z(crc, bytes.data(), bytes.size()));
#endif
}

std::uint32_t adler32_of(std::uint32_t adler, std::span<const std::uint8_t> bytes) {
#ifdef ETAK_HAS_ISAL
  return ::isal_adler32(adler, bytes.data(), bytes.size());
#else
  return static_cast<std::uint32_t>(::adler32_z(adler, bytes.data(), bytes.size()));
#endif
}

std::uint32_t adler32_of_both(std::uint32_t first, std::uint32_t second, std::size_t second_size) {
  return static_cast<std::uint32_t>(::adler32_combine(first, second, static_cast<z_off_t>(second_size)));
}

// ---- Deflater

struct Deflater::State {
  explicit State(PngLevel level_) : level(level_) {
#ifdef ETAK_HAS_ISAL
    if (level == PngLevel::fast) {
      work.resize(ISAL_DEF_LVL1_DEFAULT);
      return;
    }
#endif
    // A negative window size means a stream without header and checksum. Z_RLE looks for matches at distance
    // 1 only: on filtered rows that is twice as fast as the usual search of level 1 and compresses no worse.
    const int strategy = level == PngLevel::fast ? Z_RLE : Z_FILTERED;
    if (::deflateInit2(&zlib, zlib_level(level), Z_DEFLATED, -15, 9, strategy) != Z_OK)
      throw std::bad_alloc();
    has_zlib = true;
  }
  ~State() {
    if (has_zlib) ::deflateEnd(&zlib);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  PngLevel level;
  z_stream zlib{};
  bool has_zlib = false;
#ifdef ETAK_HAS_ISAL
  isal_zstream stream{};
  std::vector<std::uint8_t> work;
#endif
};

Deflater::Deflater(PngLevel level) : state_(std::make_unique<State>(level)) {}
Deflater::Deflater(Deflater&&) noexcept = default;
Deflater& Deflater::operator=(Deflater&&) noexcept = default;
Deflater::~Deflater() = default;

void Deflater::append(std::span<const std::uint8_t> piece, bool last, std::vector<std::uint8_t>& out) {
  assert(piece.size() < std::size_t{1} << 31);
  const std::size_t start = out.size();
  std::size_t used = start;
  // The most bytes that deflate can need: 5 more for each stored block, and the flush.
  const std::size_t bound = piece.size() + piece.size() / 1024 + 1024;
#ifdef ETAK_HAS_ISAL
  if (state_->level == PngLevel::fast) {
    isal_zstream& s = state_->stream;
    ::isal_deflate_init(&s);
    s.level = 1;
    s.level_buf = state_->work.data();
    s.level_buf_size = static_cast<std::uint32_t>(state_->work.size());
    s.flush = FULL_FLUSH;
    s.end_of_stream = last ? 1 : 0;
    // For a stream without history, ISA-L 2.30 (.write_first_byte of its level 1) computes the third byte's
    // hash from bits 16 to 47 of the stream's own address, so that one strip in a thousand is compressed to
    // other bytes from run to run. So the first byte is written here, in a stored block, and given to ISA-L
    // as history, which keeps it from that path.
    if (!piece.empty()) {
      const std::array<std::uint8_t, 6> stored{0, 1, 0, 0xFE, 0xFF, piece.front()};
      out.insert(out.end(), stored.begin(), stored.end());
      used += stored.size();
      ::isal_deflate_set_dict(&s, const_cast<std::uint8_t*>(piece.data()), 1);  // NOLINT: it only reads
      piece = piece.subspan(1);
    }
    s.next_in = const_cast<std::uint8_t*>(piece.data());  // NOLINT: it only reads
    s.avail_in = static_cast<std::uint32_t>(piece.size());
    do {
      s.avail_out = make_room(out, used, bound);
      s.next_out = out.data() + used;
      const std::uint32_t before = s.avail_out;
      ::isal_deflate(&s);
      used += before - s.avail_out;
    } while (s.avail_out == 0);
    assert(s.avail_in == 0);
    out.resize(used);
    return;
  }
#endif
  z_stream& z = state_->zlib;
  ::deflateReset(&z);
  z.next_in = const_cast<std::uint8_t*>(piece.data());  // NOLINT: it only reads
  z.avail_in = static_cast<std::uint32_t>(piece.size());
  do {
    z.avail_out = make_room(out, used, bound);
    z.next_out = out.data() + used;
    const std::uint32_t before = z.avail_out;
    ::deflate(&z, last ? Z_FINISH : Z_FULL_FLUSH);
    used += before - z.avail_out;
  } while (z.avail_out == 0);
  assert(z.avail_in == 0);
  out.resize(used);
}

// ---- Inflater

#ifdef ETAK_HAS_ISAL

struct Inflater::State {
  inflate_state isal;
  std::array<std::uint8_t, 2> header{};
  int header_size = 0;
  const char* problem = "";
};

Inflater::Inflater() : state_(new State) {
  // The state, 150 KB, is not value-initialised, because the library initialises it.
  ::isal_inflate_init(&state_->isal);
  state_->isal.crc_flag = ISAL_ZLIB_NO_HDR_VER;
}

void Inflater::feed(std::span<const std::uint8_t> input) {
  assert(state_->isal.avail_in == 0);
  state_->isal.next_in = const_cast<std::uint8_t*>(input.data());  // NOLINT: it only reads
  state_->isal.avail_in = static_cast<std::uint32_t>(input.size());
}

std::size_t Inflater::unused() const {
  // Bytes behind the checksum that the library has already moved into its bit buffer count too.
  return state_->isal.avail_in + static_cast<std::size_t>(std::max(0, state_->isal.read_in_length / 8));
}

Inflater::Status Inflater::read(std::span<std::uint8_t> out, std::size_t& written) {
  written = 0;
  State& s = *state_;
  const auto damaged = [&](const char* problem) {
    s.problem = problem;
    return Status::damaged;
  };
  while (s.header_size < 2) {
    if (s.isal.avail_in == 0) return Status::hungry;
    s.header[static_cast<std::size_t>(s.header_size++)] = *s.isal.next_in++;
    --s.isal.avail_in;
    if (s.header_size < 2) continue;
    const auto [cmf, flg] = s.header;
    if ((cmf & 15) != 8 || (cmf >> 4) > 7 || (cmf * 256 + flg) % 31 != 0) return damaged("no zlib header");
    if ((flg & 32) != 0) return damaged("a preset dictionary");
  }
  s.isal.next_out = out.data();
  s.isal.avail_out = static_cast<std::uint32_t>(std::min<std::size_t>(out.size(), std::size_t{1} << 30));
  const std::uint32_t before = s.isal.avail_out, input_before = s.isal.avail_in;
  const int code = ::isal_inflate(&s.isal);
  written = before - s.isal.avail_out;
  if (code == ISAL_INCORRECT_CHECKSUM) return damaged("the checksum (Adler-32) does not match");
  if (code == ISAL_INVALID_LOOKBACK) return damaged("a distance too far back");
  if (code == ISAL_INVALID_SYMBOL) return damaged("an invalid code");
  if (code < 0) return damaged("an invalid block");
  if (s.isal.block_state == ISAL_BLOCK_FINISH) return Status::ended;
  // The library can hold back output when the input is used up, so it needs input only when a call gives
  // nothing.
  if (written > 0 || s.isal.avail_in < input_before) return Status::more;
  return s.isal.avail_in == 0 ? Status::hungry : damaged("a stream that stands still");
}

#else

struct Inflater::State {
  State() {
    if (::inflateInit2(&zlib, 15) != Z_OK) throw std::bad_alloc();
  }
  ~State() { ::inflateEnd(&zlib); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  z_stream zlib{};
};

Inflater::Inflater() : state_(std::make_unique<State>()) {}

void Inflater::feed(std::span<const std::uint8_t> input) {
  assert(state_->zlib.avail_in == 0 && input.size() <= most_at_once);
  state_->zlib.next_in = const_cast<std::uint8_t*>(input.data());  // NOLINT: it only reads
  state_->zlib.avail_in = static_cast<std::uint32_t>(input.size());
}

std::size_t Inflater::unused() const {
  return state_->zlib.avail_in;
}

Inflater::Status Inflater::read(std::span<std::uint8_t> out, std::size_t& written) {
  z_stream& z = state_->zlib;
  z.next_out = out.data();
  z.avail_out = static_cast<std::uint32_t>(std::min(out.size(), most_at_once));
  const std::uint32_t before = z.avail_out;
  const int code = ::inflate(&z, Z_NO_FLUSH);
  written = before - z.avail_out;
  if (code == Z_STREAM_END) return Status::ended;
  if (code == Z_MEM_ERROR) throw std::bad_alloc();
  if (code != Z_OK && code != Z_BUF_ERROR) return Status::damaged;
  return written > 0 || z.avail_in > 0 ? Status::more : Status::hungry;
}

#endif

Inflater::Inflater(Inflater&&) noexcept = default;
Inflater& Inflater::operator=(Inflater&&) noexcept = default;
Inflater::~Inflater() = default;

const char* Inflater::what() const {
#ifdef ETAK_HAS_ISAL
  return state_->problem;
#else
  return state_->zlib.msg != nullptr ? state_->zlib.msg : "a preset dictionary";
#endif
}

}  // namespace etak
