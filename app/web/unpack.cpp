// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>

// Unpacks LZMA, in which the page holds etak.wasm: a quarter smaller than by gzip, and no browser unpacks it by itself.
// A module of its own, of 2 KB: without libraries, and without a word on damaged bytes, since what is packed is in the
// same file. Based on: Igor Pavlov, "LZMA specification", 2015.

namespace {

using Probability = std::uint16_t;

struct Lengths {
  Probability long_one, longest;
  Probability low[4][8], middle[4][8], high[256];
};

// For 2 bits of the place and 3 bits of the byte before, as xz writes without further options.
struct Model {
  Probability match[12][4], repeat[12], other[12], other_1[12], other_2[12], repeat_long[12][4];
  Probability slot[4][64], special[128], low_bits[16];
  Lengths lengths, repeat_lengths;
  Probability literals[8][0x300];
};

Model model;

class Reader {
 public:
  explicit Reader(const std::uint8_t* in) : in_(in) {
    for (int i = 0; i < 5; ++i) code_ = code_ << 8 | *in_++;
  }

  unsigned bit(Probability& probability) {
    const std::uint32_t bound = (range_ >> 11) * probability;
    const bool one = code_ >= bound;
    if (one) {
      range_ -= bound;
      code_ -= bound;
      probability = static_cast<Probability>(probability - (probability >> 5));
    } else {
      range_ = bound;
      probability = static_cast<Probability>(probability + ((2048 - probability) >> 5));
    }
    next();
    return one ? 1 : 0;
  }

  unsigned even_bits(unsigned count) {
    unsigned out = 0;
    for (; count > 0; --count) {
      range_ >>= 1;
      const bool one = code_ >= range_;
      if (one) code_ -= range_;
      out = out << 1 | (one ? 1 : 0);
      next();
    }
    return out;
  }

  unsigned number(Probability* tree, unsigned bits) {
    unsigned out = 1;
    for (unsigned i = 0; i < bits; ++i) out = out << 1 | bit(tree[out]);
    return out - (1U << bits);
  }

  unsigned number_from_below(Probability* tree, unsigned bits) {
    unsigned node = 1, out = 0;
    for (unsigned i = 0; i < bits; ++i) {
      const unsigned one = bit(tree[node]);
      node = node << 1 | one;
      out |= one << i;
    }
    return out;
  }

  unsigned length(Lengths& of, unsigned place) {
    if (bit(of.long_one) == 0) return 2 + number(of.low[place], 3);
    if (bit(of.longest) == 0) return 10 + number(of.middle[place], 3);
    return 18 + number(of.high, 8);
  }

 private:
  void next() {
    if (range_ >= 1U << 24) return;
    range_ <<= 8;
    code_ = code_ << 8 | *in_++;
  }

  const std::uint8_t* in_;
  std::uint32_t range_ = 0xFFFFFFFF, code_ = 0;
};

std::uint8_t literal(Reader& reader, unsigned before, bool after_match, unsigned matched) {
  Probability* const tree = model.literals[before >> 5];
  unsigned symbol = 1;
  if (after_match) {
    do {
      matched <<= 1;
      const unsigned wanted = matched & 0x100, one = reader.bit(tree[0x100 + wanted + symbol]);
      symbol = symbol << 1 | one;
      if ((wanted != 0) != (one != 0)) break;
    } while (symbol < 0x100);
  }
  while (symbol < 0x100) symbol = symbol << 1 | reader.bit(tree[symbol]);
  return static_cast<std::uint8_t>(symbol);
}

unsigned distance(Reader& reader, unsigned length) {
  const unsigned slot = reader.number(model.slot[length < 6 ? length - 2 : 3], 6);
  if (slot < 4) return slot;
  const unsigned bits = (slot >> 1) - 1, base = (2 | (slot & 1)) << bits;
  if (slot < 14) return base + reader.number_from_below(model.special + base - slot, bits);
  return base + (reader.even_bits(bits - 4) << 4) + reader.number_from_below(model.low_bits, 4);
}

// The state counts what came last: below 7 a literal.
struct State {
  unsigned value = 0;
  void after_literal() { value = value < 4 ? 0 : value < 10 ? value - 3 : value - 6; }
  void after_match() { value = value < 7 ? 7 : 10; }
  void after_repeat() { value = value < 7 ? 8 : 11; }
  void after_short_repeat() { value = value < 7 ? 9 : 11; }
};

// Which of the last four distances is taken again.
unsigned repeated(Reader& reader, unsigned state) {
  if (reader.bit(model.other[state]) == 0) return 0;
  if (reader.bit(model.other_1[state]) == 0) return 1;
  return 2 + reader.bit(model.other_2[state]);
}

// Puts a distance before those that came after it.
void take_from(unsigned (&back)[4], unsigned place, unsigned distance) {
  for (; place > 0; --place) back[place] = back[place - 1];
  back[0] = distance;
}

void unpack_to(Reader reader, std::uint8_t* out, std::size_t size) {
  State state;
  unsigned back[4] = {0, 0, 0, 0};
  for (std::size_t at = 0; at < size;) {
    const unsigned place = at & 3;
    if (reader.bit(model.match[state.value][place]) == 0) {
      const bool after_match = state.value >= 7;
      out[at] =
          literal(reader, at > 0 ? out[at - 1] : 0, after_match, after_match ? out[at - back[0] - 1] : 0);
      ++at;
      state.after_literal();
      continue;
    }
    unsigned length = 1;
    if (reader.bit(model.repeat[state.value]) == 0) {
      length = reader.length(model.lengths, place);
      state.after_match();
      take_from(back, 3, distance(reader, length));
    } else if (const unsigned which = repeated(reader, state.value);
               which == 0 && reader.bit(model.repeat_long[state.value][place]) == 0) {
      state.after_short_repeat();
    } else {
      take_from(back, which, back[which]);
      length = reader.length(model.repeat_lengths, place);
      state.after_repeat();
    }
    for (; length > 0 && at < size; --length, ++at) out[at] = out[at - back[0] - 1];
  }
}

}  // namespace

extern "C" {

extern std::uint8_t __heap_base;

/// Where so many bytes of memory are free, behind all that was asked for before.
[[clang::export_name("room")]] std::uint8_t* room(std::size_t size) {
  static std::uint8_t* next = &__heap_base;
  constexpr std::size_t page = 65536;
  std::uint8_t* const out = next;
  next += (size + 15) / 16 * 16;
  const auto wanted =
      (reinterpret_cast<std::size_t>(next) + page - 1) / page;  // NOLINT: addresses are numbers here
  const std::size_t there = __builtin_wasm_memory_size(0);
  if (wanted > there) __builtin_wasm_memory_grow(0, wanted - there);
  return out;
}

/// Unpacks to `size` bytes what lies behind the head of 13 bytes of a file of LZMA.
[[clang::export_name("unpack")]] void unpack(const std::uint8_t* packed, std::uint8_t* out,
                                             std::size_t size) {
  auto* const all = reinterpret_cast<Probability*>(&model);  // NOLINT: nothing else is in it
  for (std::size_t i = 0; i < sizeof model / sizeof *all; ++i) all[i] = 1024;
  unpack_to(Reader(packed + 13), out, size);
}

}  // extern "C"
