// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/image/files/deflate.h"

namespace etak {

/// RFC 1951, section 3.2.5: the first length or distance of each symbol, and how many bits follow it.
struct DeflateRange {
  std::uint16_t first;
  std::uint8_t bits;
};
inline constexpr std::array<DeflateRange, 29> deflate_lengths{
    {{3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
     {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
     {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}}};
inline constexpr std::array<DeflateRange, 30> deflate_distances{
    {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},     {9, 2},     {13, 2},
     {17, 3},    {25, 3},    {33, 4},    {49, 4},     {65, 5},     {97, 5},    {129, 6},   {193, 6},
     {257, 7},   {385, 7},   {513, 8},   {769, 8},    {1025, 9},   {1537, 9},  {2049, 10}, {3073, 10},
     {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}}};

/// Inflates a zlib stream (RFC 1950 around RFC 1951) without any library, from input in pieces, as zlib does: codes that
/// zlib refuses are refused, and the window is always 32 KiB. Inflater (deflate.h) uses it where etak is built without
/// zlib and ISA-L, which are several times as fast.
class PlainInflater {
 public:
  using Status = Inflater::Status;

  /// Gives the next piece; the one before must be used up.
  void feed(std::span<const std::uint8_t> input) { input_ = input; }
  Status read(std::span<std::uint8_t> out, std::size_t& written);
  /// How many bytes of the last piece lie behind the end of the stream.
  std::size_t unused() const { return input_.size() + bit_count_ / 8; }
  /// Why the stream is damaged, in words.
  const char* what() const { return problem_; }

 private:
  // The symbols of a Huffman code by the bits that come first in the stream.
  class Code {
   public:
    static constexpr unsigned longest = 15;
    /// False for lengths that are no complete code. Two are taken all the same where `may_be_sparse`: no symbol at all,
    /// and a single one of one bit.
    bool make(std::span<const std::uint8_t> lengths, bool may_be_sparse);
    /// The symbol that `bits` begins with, and its length: 0 where no symbol begins so.
    unsigned find(std::uint64_t bits, unsigned& length) const;

   private:
    static constexpr unsigned table_bits = 10;
    struct Entry {
      std::uint16_t symbol = 0;
      std::uint8_t length = 0;  // 0: a longer code, or none
    };
    std::array<Entry, 1U << table_bits> table_{};
    std::array<std::uint16_t, longest + 1> count_{};  // of the symbols of each length
    std::array<std::uint16_t, 288> symbols_{};        // in the order of their codes
  };
  enum class Part { header, block, stored_size, stored, length_code, lengths, symbols, checksum, ended };

  // Each of these returns false where it needs more input or has failed; it is called again with the next piece.
  bool has_bits(unsigned count);
  bool step();
  bool read_header();
  bool begin_block();
  bool read_stored_size();
  bool copy_stored();
  bool read_length_code();
  bool read_lengths();
  bool read_symbols();
  bool read_match(unsigned symbol, unsigned length);
  bool read_checksum();

  std::uint32_t take(unsigned count);
  bool fail(const char* problem);
  bool make_codes(std::span<const std::uint8_t> symbols, std::span<const std::uint8_t> distances);
  void end_block();
  void make_room(std::size_t wanted);

  std::span<const std::uint8_t> input_;
  std::uint64_t bits_ = 0;  // the next ones, the first one lowest; those beyond bit_count_ are 0
  unsigned bit_count_ = 0;
  Part part_ = Part::header;
  bool last_block_ = false;
  const char* problem_ = "";

  std::size_t stored_left_ = 0;
  std::array<std::uint8_t, 320>
      lengths_{};  // of the code that is read: those of its lengths first, then all others
  unsigned lengths_read_ = 0, length_codes_ = 0, symbols_ = 0, distances_ = 0;
  Code length_code_, symbol_code_, distance_code_;

  // The last 32 KiB of output, and behind `given_` what nobody has read yet. Inflating stops at `wanted_`.
  std::vector<std::uint8_t> window_;
  std::size_t end_ = 0, given_ = 0, wanted_ = 0;
  std::uint32_t adler_ = 1;
};

}  // namespace etak
