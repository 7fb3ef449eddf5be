// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/plain_inflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/image/files/plain_deflate.h"

namespace etak {
namespace {

constexpr std::size_t window_size = 32768, longest_match = 258;
// So much is inflated before the window is moved to the front again.
constexpr std::size_t buffer_size = 8 * window_size;
constexpr unsigned end_of_block = 256, most_symbols = 286;

// RFC 1951, section 3.2.7: the order in which the lengths of the code of lengths come.
constexpr std::array<std::uint8_t, 19> length_order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                    11, 4,  12, 3, 13, 2, 14, 1, 15};

constexpr const char* bad_code = "an invalid code";
constexpr const char* bad_block = "an invalid block";

std::uint32_t low_bits(std::uint64_t bits, unsigned count) {
  return static_cast<std::uint32_t>(bits & ((std::uint64_t{1} << count) - 1));
}

}  // namespace

// ---- codes

bool PlainInflater::Code::make(std::span<const std::uint8_t> lengths, bool may_be_sparse) {
  table_.fill({});
  count_.fill(0);
  for (const std::uint8_t length : lengths) ++count_[length];
  count_[0] = 0;
  int left = 1;
  unsigned most = 0;
  for (unsigned length = 1; length <= longest; ++length) {
    left = 2 * left - count_[length];
    if (left < 0) return false;
    if (count_[length] > 0) most = length;
  }
  if (left > 0 && !(may_be_sparse && most <= 1)) return false;
  // Codes of one length are consecutive numbers, in the order of the symbols (section 3.2.2).
  std::array<std::uint16_t, longest + 2> offset{};
  std::array<std::uint32_t, longest + 2> next{};
  for (unsigned length = 1; length <= longest; ++length) {
    offset[length + 1] = static_cast<std::uint16_t>(offset[length] + count_[length]);
    next[length + 1] = (next[length] + count_[length]) * 2;
  }
  for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
    const unsigned length = lengths[symbol];
    if (length == 0) continue;
    symbols_[offset[length]++] = static_cast<std::uint16_t>(symbol);
    const std::uint32_t code = next[length]++;
    if (length > table_bits) continue;
    std::uint32_t reversed = 0;
    for (unsigned i = 0; i < length; ++i) reversed |= (code >> i & 1) << (length - 1 - i);
    for (std::uint32_t at = reversed; at < table_.size(); at += 1U << length)
      table_[at] = {static_cast<std::uint16_t>(symbol), static_cast<std::uint8_t>(length)};
  }
  return true;
}

unsigned PlainInflater::Code::find(std::uint64_t bits, unsigned& length) const {
  const Entry& entry = table_[low_bits(bits, table_bits)];
  length = entry.length;
  if (length != 0) return entry.symbol;
  // Codes that are longer than the table's: bit by bit, the distance from the first code of each length.
  std::uint32_t code = 0, first = 0, index = 0;
  for (length = 1; length <= longest; ++length, bits >>= 1) {
    code |= static_cast<std::uint32_t>(bits & 1);
    if (code < first + count_[length]) return symbols_[index + code - first];
    index += count_[length];
    first = (first + count_[length]) * 2;
    code *= 2;
  }
  length = 0;
  return 0;
}

// ---- bits

bool PlainInflater::has_bits(unsigned count) {
  constexpr unsigned most = 56;
  if (bit_count_ >= count) return true;
  if (std::endian::native == std::endian::little && input_.size() >= sizeof(std::uint64_t)) {
    std::uint64_t next = 0;
    std::memcpy(&next, input_.data(), sizeof next);
    const unsigned bytes = (most + 7 - bit_count_) / 8;
    bits_ |= next << bit_count_;
    bit_count_ += 8 * bytes;
    bits_ &= (std::uint64_t{1} << bit_count_) - 1;
    input_ = input_.subspan(bytes);
    return true;
  }
  for (; bit_count_ <= most && !input_.empty(); bit_count_ += 8) {
    bits_ |= std::uint64_t{input_.front()} << bit_count_;
    input_ = input_.subspan(1);
  }
  return bit_count_ >= count;
}

std::uint32_t PlainInflater::take(unsigned count) {
  const std::uint32_t out = low_bits(bits_, count);
  bits_ >>= count;
  bit_count_ -= count;
  return out;
}

bool PlainInflater::fail(const char* problem) {
  problem_ = problem;
  return false;
}

// ---- the stream

PlainInflater::Status PlainInflater::read(std::span<std::uint8_t> out, std::size_t& written) {
  written = 0;
  for (bool goes_on = true;; goes_on = step()) {
    const std::size_t count = std::min(out.size() - written, end_ - given_);
    if (count > 0) {
      std::memcpy(out.data() + written, window_.data() + given_, count);
      adler_ = plain_adler32(adler_, {window_.data() + given_, count});
      given_ += count;
      written += count;
    }
    if (given_ < end_) return Status::more;
    if (part_ == Part::ended) return Status::ended;
    if (!goes_on) return *problem_ != '\0' ? Status::damaged : Status::hungry;
    if (written == out.size()) return Status::more;
    make_room(out.size() - written);
  }
}

// Everything before end_ is given away here, so that only the window must stay.
void PlainInflater::make_room(std::size_t wanted) {
  if (window_.empty()) window_.resize(buffer_size + longest_match);
  if (end_ >= buffer_size) {
    std::memmove(window_.data(), window_.data() + end_ - window_size, window_size);
    end_ = given_ = window_size;
  }
  wanted_ = std::min(end_ + wanted, buffer_size);
}

bool PlainInflater::step() {
  switch (part_) {
    case Part::header:
      return read_header();
    case Part::block:
      return begin_block();
    case Part::stored_size:
      return read_stored_size();
    case Part::stored:
      return copy_stored();
    case Part::length_code:
      return read_length_code();
    case Part::lengths:
      return read_lengths();
    case Part::symbols:
      return read_symbols();
    case Part::checksum:
      return read_checksum();
    case Part::ended:
      break;
  }
  return false;
}

bool PlainInflater::read_header() {
  if (!has_bits(16)) return false;
  const std::uint32_t cmf = take(8), flg = take(8);
  if ((cmf & 15) != 8 || (cmf >> 4) > 7 || (cmf * 256 + flg) % 31 != 0) return fail("no zlib header");
  if ((flg & 32) != 0) return fail("a preset dictionary");
  part_ = Part::block;
  return true;
}

bool PlainInflater::begin_block() {
  constexpr unsigned stored = 0, fixed = 1, dynamic = 2, dynamic_bits = 14;
  // A block of codes of its own has 14 bits more, which are taken together with these.
  if (!has_bits(3)) return false;
  const unsigned kind = low_bits(bits_ >> 1, 2);
  if (kind == dynamic && !has_bits(3 + dynamic_bits)) return false;
  last_block_ = take(1) == 1;
  take(2);
  if (kind == stored) {
    take(bit_count_ % 8);
    part_ = Part::stored_size;
    return true;
  }
  if (kind == fixed) {
    // Section 3.2.6.
    std::array<std::uint8_t, 288> symbols{};
    for (std::size_t i = 0; i < symbols.size(); ++i) symbols[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    std::array<std::uint8_t, 32> distances{};
    distances.fill(5);
    return make_codes(symbols, distances);
  }
  if (kind != dynamic) return fail(bad_block);
  symbols_ = take(5) + 257;
  distances_ = take(5) + 1;
  length_codes_ = take(4) + 4;
  if (symbols_ > most_symbols || distances_ > deflate_distances.size()) return fail(bad_block);
  lengths_.fill(0);
  lengths_read_ = 0;
  part_ = Part::length_code;
  return true;
}

bool PlainInflater::make_codes(std::span<const std::uint8_t> symbols,
                               std::span<const std::uint8_t> distances) {
  if (!symbol_code_.make(symbols, true) || !distance_code_.make(distances, true)) return fail(bad_block);
  part_ = Part::symbols;
  return true;
}

void PlainInflater::end_block() {
  part_ = last_block_ ? Part::checksum : Part::block;
  if (last_block_) take(bit_count_ % 8);
}

bool PlainInflater::read_stored_size() {
  if (!has_bits(32)) return false;
  stored_left_ = take(16);
  if ((stored_left_ ^ take(16)) != 0xffff) return fail(bad_block);
  part_ = Part::stored;
  return true;
}

bool PlainInflater::copy_stored() {
  for (; bit_count_ > 0 && stored_left_ > 0 && end_ < wanted_; --stored_left_)
    window_[end_++] = static_cast<std::uint8_t>(take(8));
  if (bit_count_ == 0) {
    const std::size_t count = std::min({stored_left_, wanted_ - end_, input_.size()});
    if (count > 0) std::memcpy(window_.data() + end_, input_.data(), count);
    input_ = input_.subspan(count);
    end_ += count;
    stored_left_ -= count;
  }
  if (stored_left_ == 0) end_block();
  return stored_left_ == 0 || end_ == wanted_;
}

bool PlainInflater::read_length_code() {
  for (; lengths_read_ < length_codes_; ++lengths_read_) {
    if (!has_bits(3)) return false;
    lengths_[length_order[lengths_read_]] = static_cast<std::uint8_t>(take(3));
  }
  if (!length_code_.make(std::span(lengths_).first(length_order.size()), false)) return fail(bad_block);
  lengths_read_ = 0;
  part_ = Part::lengths;
  return true;
}

bool PlainInflater::read_lengths() {
  // Symbols 16 to 18 repeat a length: their bits, and the fewest times.
  constexpr unsigned first_repeat = 16;
  constexpr std::array<DeflateRange, 3> repeats{{{3, 2}, {3, 3}, {11, 7}}};
  const unsigned all = symbols_ + distances_;
  while (lengths_read_ < all) {
    constexpr unsigned most_bits = 14;
    has_bits(most_bits);
    unsigned length = 0;
    const unsigned symbol = length_code_.find(bits_, length);
    const DeflateRange repeat = symbol < first_repeat ? DeflateRange{1, 0} : repeats[symbol - first_repeat];
    if (length + repeat.bits > bit_count_) return false;
    if (length == 0) return fail(bad_block);
    take(length);
    const unsigned times = repeat.first + take(repeat.bits);
    if (lengths_read_ + times > all || (symbol == first_repeat && lengths_read_ == 0)) return fail(bad_block);
    const unsigned value = symbol < first_repeat    ? symbol
                           : symbol == first_repeat ? lengths_[lengths_read_ - 1]
                                                    : 0;
    std::fill_n(lengths_.data() + lengths_read_, times, static_cast<std::uint8_t>(value));
    lengths_read_ += times;
  }
  if (lengths_[end_of_block] == 0) return fail(bad_block);
  return make_codes(std::span(lengths_).first(symbols_), std::span(lengths_).subspan(symbols_, distances_));
}

bool PlainInflater::read_symbols() {
  // The most bits of a match: two codes of 15, and 5 and 13 that follow them.
  constexpr unsigned most_bits = 48;
  while (end_ < wanted_) {
    has_bits(most_bits);
    unsigned length = 0;
    const unsigned symbol = symbol_code_.find(bits_, length);
    if (length == 0 && bit_count_ >= Code::longest) return fail(bad_code);
    if (length == 0 || length > bit_count_) return false;
    if (symbol > end_of_block) {
      if (!read_match(symbol, length)) return false;
      continue;
    }
    take(length);
    if (symbol == end_of_block) {
      end_block();
      return true;
    }
    window_[end_++] = static_cast<std::uint8_t>(symbol);
  }
  return true;
}

bool PlainInflater::read_match(unsigned symbol, unsigned length) {
  const unsigned at = symbol - end_of_block - 1;
  if (at >= deflate_lengths.size()) return fail(bad_code);
  const unsigned before = length + deflate_lengths[at].bits;
  unsigned distance_length = 0;
  const unsigned distance_at = distance_code_.find(bits_ >> before, distance_length);
  if (distance_length == 0) return bit_count_ >= before + Code::longest ? fail(bad_code) : false;
  if (distance_at >= deflate_distances.size())
    return bit_count_ >= before + distance_length ? fail(bad_code) : false;
  if (before + distance_length + deflate_distances[distance_at].bits > bit_count_) return false;
  take(length);
  const std::size_t count = deflate_lengths[at].first + take(deflate_lengths[at].bits);
  take(distance_length);
  const std::size_t distance =
      deflate_distances[distance_at].first + take(deflate_distances[distance_at].bits);
  if (distance > end_) return fail("a distance too far back");
  std::uint8_t* const to = window_.data() + end_;
  const std::uint8_t* const from = to - distance;
  if (distance >= count)
    std::memcpy(to, from, count);
  else
    for (std::size_t i = 0; i < count; ++i) to[i] = from[i];
  end_ += count;
  return true;
}

bool PlainInflater::read_checksum() {
  if (!has_bits(32)) return false;
  std::uint32_t sum = 0;
  for (int i = 0; i < 4; ++i) sum = sum << 8 | take(8);
  if (sum != adler_) return fail("the checksum (Adler-32) does not match");
  part_ = Part::ended;
  return true;
}

}  // namespace etak
