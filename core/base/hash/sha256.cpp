// SPDX-License-Identifier: Apache-2.0
#include "core/base/hash/sha256.h"

#ifdef ETAK_SHA256_X86
#include <cpuid.h>
#endif

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/base/bytes/hex.h"
#include "core/base/files/input.h"
#include "core/base/hash/sha256_blocks.h"

namespace etak {

const std::array<std::uint32_t, 64> sha256_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

namespace {

void add_block(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes) {
  std::array<std::uint32_t, 64> w;
  for (std::size_t i = 0; i < 16; ++i)
    w[i] = std::uint32_t{bytes[4 * i]} << 24 | std::uint32_t{bytes[4 * i + 1]} << 16 |
           std::uint32_t{bytes[4 * i + 2]} << 8 | bytes[4 * i + 3];
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
    const std::uint32_t s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
    w[i] = w[i - 16] + s0 + w[i - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const std::uint32_t t1 = h + s1 + ((e & f) ^ (~e & g)) + sha256_constants[i] + w[i];
    const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const std::uint32_t t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + t1;
    d = c;
    c = b;
    b = a;
    a = t1 + t2;
  }
  const std::array<std::uint32_t, 8> sum{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) state[i] += sum[i];
}

}  // namespace

void sha256_blocks_plain(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes, std::size_t blocks) {
  for (; blocks > 0; --blocks, bytes += 64) add_block(state, bytes);
}

#ifndef ETAK_SHA256_X86
void sha256_blocks_x86(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes, std::size_t blocks) {
  sha256_blocks_plain(state, bytes, blocks);
}
#endif

bool has_sha256_x86() {
#ifdef ETAK_SHA256_X86
  unsigned a = 0, b = 0, c = 0, d = 0;
  const bool sse4 = __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_SSE4_1) != 0 && (c & bit_SSSE3) != 0;
  return sse4 && __get_cpuid_count(7, 0, &a, &b, &c, &d) != 0 && (b & bit_SHA) != 0;
#else
  return false;
#endif
}

namespace {

void add_blocks(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes, std::size_t blocks) {
  static const bool fast = has_sha256_x86();
  (fast ? sha256_blocks_x86 : sha256_blocks_plain)(state, bytes, blocks);
}

}  // namespace

void Sha256::add(std::string_view bytes) {
  length_ += bytes.size();
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());  // NOLINT: bytes as numbers
  std::size_t count = bytes.size();
  if (rest_size_ > 0) {
    const std::size_t part = std::min(count, rest_.size() - rest_size_);
    std::copy_n(from, part, rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_));
    rest_size_ += part;
    from += part;
    count -= part;
    if (rest_size_ < rest_.size()) return;
    add_blocks(state_, rest_.data(), 1);
    rest_size_ = 0;
  }
  add_blocks(state_, from, count / rest_.size());
  from += count - count % rest_.size();
  count %= rest_.size();
  std::copy_n(from, count, rest_.begin());
  rest_size_ = count;
}

std::string Sha256::finish_bytes() {
  const std::uint64_t bits = 8 * length_;
  std::string end(1, '\x80');
  end.append((119 - length_ % 64) % 64, '\0');
  for (int shift = 56; shift >= 0; shift -= 8) end += static_cast<char>(bits >> shift & 255);
  add(end);
  std::string out;
  for (const std::uint32_t word : state_)
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(word >> shift & 255);
  return out;
}

std::string Sha256::finish() {
  return hex(finish_bytes());
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.finish();
}

std::string hmac_sha256(std::string_view key, std::string_view bytes) {
  constexpr std::size_t block = 64;
  std::string padded(key);
  if (padded.size() > block) {
    Sha256 hash;
    hash.add(key);
    padded = hash.finish_bytes();
  }
  padded.resize(block, '\0');
  const auto keyed = [&](int pad, std::string_view text) {
    std::string start = padded;
    for (char& c : start) c = static_cast<char>(c ^ pad);
    Sha256 hash;
    hash.add(start);
    hash.add(text);
    return hash;
  };
  return keyed(0x5c, keyed(0x36, bytes).finish_bytes()).finish();
}

bool same_digest(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing |= static_cast<unsigned char>(a[i] ^ b[i]);
  return differing == 0;
}

std::string sha256_of_file(const std::string& path) {
  sys::FileInfo info;
  return sha256_of_file(path, info);
}

std::string sha256_of_file(const std::string& path, sys::FileInfo& info, SeenAsFile seen) {
  Sha256 hash;
  return take_bytes(path, info, seen, [&](std::string_view bytes) { hash.add(bytes); }) ? hash.finish() : "";
}

}  // namespace etak
