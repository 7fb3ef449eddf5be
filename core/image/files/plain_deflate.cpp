// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/plain_deflate.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/image/files/plain_inflate.h"

namespace etak {
namespace {

constexpr std::uint32_t adler_modulus = 65521;

// The remainders of all bytes by the polynomial of ISO 3309.
constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> out{};
  for (std::uint32_t byte = 0; byte < out.size(); ++byte) {
    out[byte] = byte;
    for (int bit = 0; bit < 8; ++bit) out[byte] = out[byte] >> 1 ^ ((out[byte] & 1) != 0 ? 0xEDB88320U : 0);
  }
  return out;
}();

// Writes bits, the first one lowest.
class DeflateBits {
 public:
  explicit DeflateBits(std::vector<std::uint8_t>& out) : out_(out) {}
  void add(std::uint32_t bits, unsigned count) {
    bits_ |= std::uint64_t{bits} << count_;
    for (count_ += count; count_ >= 8; count_ -= 8, bits_ >>= 8)
      out_.push_back(static_cast<std::uint8_t>(bits_));
  }
  /// A code, whose highest bit comes first.
  void add_code(std::uint32_t code, unsigned count) {
    std::uint32_t reversed = 0;
    for (unsigned i = 0; i < count; ++i) reversed |= (code >> i & 1) << (count - 1 - i);
    add(reversed, count);
  }
  void to_whole_byte() {
    if (count_ > 0) add(0, 8 - count_);
  }

 private:
  std::vector<std::uint8_t>& out_;
  std::uint64_t bits_ = 0;
  unsigned count_ = 0;
};

// RFC 1951, section 3.2.6.
void add_symbol(DeflateBits& to, unsigned symbol) {
  if (symbol < 144)
    to.add_code(0x30 + symbol, 8);
  else if (symbol < 256)
    to.add_code(0x190 + symbol - 144, 9);
  else if (symbol < 280)
    to.add_code(symbol - 256, 7);
  else
    to.add_code(0xC0 + symbol - 280, 8);
}

template <std::size_t count>
unsigned range_of(const std::array<DeflateRange, count>& ranges, std::size_t value) {
  const auto behind =
      std::find_if(ranges.begin(), ranges.end(), [&](const DeflateRange& r) { return r.first > value; });
  return static_cast<unsigned>(behind - ranges.begin()) - 1;
}

void add_match(DeflateBits& to, std::size_t length, std::size_t distance) {
  // The longest length has a symbol of its own, which no other range holds.
  const unsigned at = range_of(deflate_lengths, length), from = range_of(deflate_distances, distance);
  add_symbol(to, 257 + at);
  to.add(static_cast<std::uint32_t>(length - deflate_lengths[at].first), deflate_lengths[at].bits);
  to.add_code(from, 5);
  to.add(static_cast<std::uint32_t>(distance - deflate_distances[from].first), deflate_distances[from].bits);
}

}  // namespace

std::uint32_t plain_crc32(std::uint32_t crc, std::span<const std::uint8_t> bytes) {
  crc = ~crc;
  for (const std::uint8_t byte : bytes) crc = crc >> 8 ^ crc_table[(crc ^ byte) & 255];
  return ~crc;
}

std::uint32_t plain_adler32(std::uint32_t adler, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t before_overflow = 5552;  // sums of so many bytes fit into 32 bits
  std::uint32_t a = adler & 0xffff, b = adler >> 16;
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min(bytes.size(), before_overflow));
    for (const std::uint8_t byte : piece) b += a += byte;
    a %= adler_modulus;
    b %= adler_modulus;
    bytes = bytes.subspan(piece.size());
  }
  return b << 16 | a;
}

std::uint32_t plain_adler32_of_both(std::uint32_t first, std::uint32_t second, std::size_t second_size) {
  // Each byte of the second piece adds the sum of the first to b once more; the sum of nothing is 1.
  const std::uint64_t size = second_size % adler_modulus;
  const std::uint64_t a1 = first & 0xffff, b1 = first >> 16, a2 = second & 0xffff, b2 = second >> 16;
  const std::uint64_t a = (a1 + a2 + adler_modulus - 1) % adler_modulus;
  const std::uint64_t b = (b1 + b2 + size * (a1 + adler_modulus - 1)) % adler_modulus;
  return static_cast<std::uint32_t>(b << 16 | a);
}

// One block of the fixed codes, with the newest match of at least four bytes wherever there is one.
void PlainDeflater::append(std::span<const std::uint8_t> piece, bool last, std::vector<std::uint8_t>& out) {
  constexpr std::size_t window = 32768, shortest = 4, longest = 258;
  constexpr unsigned hash_bits = 15;
  places_.assign(std::size_t{1} << hash_bits, 0);
  DeflateBits bits(out);
  bits.add(last ? 3 : 2, 3);
  for (std::size_t at = 0; at < piece.size();) {
    std::size_t length = 0, from = 0;
    if (piece.size() - at >= shortest) {
      std::uint32_t next = 0;
      std::memcpy(&next, piece.data() + at, shortest);
      std::uint32_t& place = places_[next * 2654435761U >> (32 - hash_bits)];
      if (place != 0 && at - (place - 1) <= window) {
        from = place - 1;
        const std::size_t most = std::min(longest, piece.size() - at);
        while (length < most && piece[from + length] == piece[at + length]) ++length;
      }
      place = static_cast<std::uint32_t>(at + 1);
    }
    if (length < shortest) {
      add_symbol(bits, piece[at++]);
      continue;
    }
    add_match(bits, length, at - from);
    at += length;
  }
  add_symbol(bits, 256);
  // An empty stored block ends a piece that others follow.
  if (!last) bits.add(0, 3);
  bits.to_whole_byte();
  if (!last) out.insert(out.end(), {0, 0, 0xFF, 0xFF});
}

}  // namespace etak
