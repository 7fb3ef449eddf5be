// SPDX-License-Identifier: Apache-2.0
#include "core/base/hash/content_hash.h"

#include <cstring>

namespace etak {
namespace {

// Odd numbers with well mixed bits: fractions of the golden ratio and of square roots of 2, 3 and 5.
constexpr std::array<std::uint64_t, 4> factors{0x9e3779b97f4a7c15, 0x6a09e667f3bcc909, 0xbb67ae8584caa73b,
                                               0x3c6ef372fe94f82b};

std::uint64_t word(const unsigned char* bytes) {
  std::uint64_t out;
  std::memcpy(&out, bytes, sizeof out);
  return out;  // etak runs on little-endian machines only
}

// A multiplication moves bits up only; the shift brings them down again.
std::uint64_t mixed(std::uint64_t lane, std::uint64_t value, std::uint64_t factor) {
  lane = (lane ^ value) * factor;
  return lane ^ (lane >> 29);
}

}  // namespace

void ContentHash::add(const void* data, std::size_t count) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  length_ += count;
  std::array<std::uint64_t, 4> lanes = lanes_;
  for (; count >= 32; bytes += 32, count -= 32)
    for (std::size_t i = 0; i < 4; ++i) lanes[i] = mixed(lanes[i], word(bytes + 8 * i), factors[i]);
  if (count > 0) {
    unsigned char last[32] = {};
    std::memcpy(last, bytes, count);
    for (std::size_t i = 0; i < 4; ++i) lanes[i] = mixed(lanes[i], word(last + 8 * i), factors[i]);
  }
  lanes_ = lanes;
}

std::array<std::uint64_t, 2> ContentHash::value() const {
  std::array<std::uint64_t, 2> out{length_ * factors[0], length_ ^ factors[2]};
  for (std::size_t round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < 4; ++i) {
      out[0] = mixed(out[0], lanes_[i] + out[1], factors[i]);
      out[1] = mixed(out[1], lanes_[3 - i] ^ out[0], factors[3 - i]);
      out[1] = (out[1] << 31) | (out[1] >> 33);
    }
  return out;
}

std::string ContentHash::hex() const {
  constexpr char digits[] = "0123456789abcdef";
  std::string out;
  for (const std::uint64_t part : value())
    for (int shift = 60; shift >= 0; shift -= 4) out += digits[(part >> shift) & 15];
  return out;
}

}  // namespace etak
