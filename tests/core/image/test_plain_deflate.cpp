// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <vector>

#include "core/image/files/plain_deflate.h"
#include "core/image/files/plain_inflate.h"

using namespace etak;

namespace {

using Bytes = std::vector<std::uint8_t>;
enum class Verdict { ended, damaged, cut };

struct Inflated {
  Verdict verdict = Verdict::cut;
  Bytes bytes;
  std::size_t behind = 0;  // bytes of the input behind the end of the stream
};

// Random bytes, few values, near repetitions, one value, and both kinds in turn.
Bytes content(std::mt19937& random, std::size_t size, unsigned kind) {
  Bytes out;
  for (std::size_t i = 0; i < size; ++i) {
    const auto any = static_cast<std::uint8_t>(random());
    const bool early = i <= 50;
    switch (kind % 5) {
      case 0:
        out.push_back(any);
        break;
      case 1:
        out.push_back(any % 4);
        break;
      case 2:
        out.push_back(early ? any : out[i - 1 - any % 40]);
        break;
      case 3:
        out.push_back(7);
        break;
      default:
        out.push_back(i % 1000 < 500 ? any % 3 : any);
    }
  }
  return out;
}

Bytes deflated_by_zlib(const Bytes& in, int level, int strategy) {
  Bytes out(in.size() * 2 + 1000);
  z_stream z{};
  REQUIRE(deflateInit2(&z, level, Z_DEFLATED, 15, 9, strategy) == Z_OK);
  z.next_in = const_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  z.next_out = out.data();
  z.avail_out = static_cast<uInt>(out.size());
  REQUIRE(deflate(&z, Z_FINISH) == Z_STREAM_END);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}

Inflated by_zlib(const Bytes& in) {
  Inflated out;
  z_stream z{};
  REQUIRE(inflateInit2(&z, 15) == Z_OK);
  z.next_in = const_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  Bytes room(65536);
  int code = Z_OK;
  while (code == Z_OK) {
    z.next_out = room.data();
    z.avail_out = static_cast<uInt>(room.size());
    code = inflate(&z, Z_NO_FLUSH);
    out.bytes.insert(out.bytes.end(), room.data(), z.next_out);
  }
  out.verdict = code == Z_STREAM_END ? Verdict::ended : code == Z_BUF_ERROR ? Verdict::cut : Verdict::damaged;
  out.behind = z.avail_in;
  inflateEnd(&z);
  return out;
}

//   piece, room   bytes given and taken at once
Inflated by_own(const Bytes& in, std::size_t piece, std::size_t room) {
  Inflated out;
  PlainInflater inflater;
  Bytes taken(room);
  for (std::size_t at = 0;;) {
    std::size_t written = 0;
    const auto status = inflater.read(taken, written);
    out.bytes.insert(out.bytes.end(), taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(written));
    if (status == PlainInflater::Status::more) continue;
    out.verdict = status == PlainInflater::Status::ended     ? Verdict::ended
                  : status == PlainInflater::Status::damaged ? Verdict::damaged
                                                             : Verdict::cut;
    out.behind = inflater.unused() + in.size() - at;
    if (status != PlainInflater::Status::hungry || at == in.size()) return out;
    const std::size_t count = std::min(piece, in.size() - at);
    inflater.feed({in.data() + at, count});
    at += count;
  }
}

}  // namespace

TEST_CASE(
    "the inflater of our own gives what zlib gives, whole, cut and with wrong bits, in pieces of any size") {
  std::mt19937 random(7);
  for (unsigned i = 0; i < 1200; ++i) {
    Bytes stream = deflated_by_zlib(content(random, random() % 70000, i), static_cast<int>(1 + i % 9),
                                    static_cast<int>(i % 5));
    if (i % 4 == 1)
      for (unsigned flips = 0; flips < 3; ++flips)
        stream[random() % stream.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    if (i % 4 == 2) stream.resize(random() % stream.size());
    if (i % 4 == 3)
      stream[2 + random() % std::min<std::size_t>(40, stream.size() - 2)] =
          static_cast<std::uint8_t>(random());
    stream.resize(stream.size() + (i % 8 == 0 ? random() % 20 : 0), 0);
    const Inflated expected = by_zlib(stream);
    const Inflated seen = by_own(stream, 1 + random() % (i % 3 == 0 ? 7 : 5000), 1 + random() % 70000);
    INFO("stream " << i);
    REQUIRE(seen.verdict == expected.verdict);
    if (expected.verdict == Verdict::damaged) continue;  // the two may notice it some bytes apart
    REQUIRE((seen.bytes == expected.bytes));
    if (expected.verdict == Verdict::ended) REQUIRE(seen.behind == expected.behind);
  }
}

TEST_CASE("zlib reads what the deflater of our own writes, in one piece and in several, with its checksums") {
  std::mt19937 random(3);
  for (unsigned i = 0; i < 200; ++i) {
    const Bytes in = content(random, random() % 200000, i);
    Bytes out{0x78, 0x9C};
    std::uint32_t sum = 1;
    PlainDeflater deflater;
    for (std::size_t at = 0; at < in.size() || at == 0;) {
      const std::size_t count =
          std::min<std::size_t>(in.size() - at, i % 3 == 0 ? in.size() : 1 + random() % 50000);
      const std::span<const std::uint8_t> piece(in.data() + at, count);
      at += count;
      sum = plain_adler32_of_both(sum, plain_adler32(1, piece), count);
      deflater.append(piece, at == in.size(), out);
      if (at == in.size()) break;
    }
    CHECK(sum == adler32_z(1, in.data(), in.size()));
    CHECK(plain_crc32(0, in) == crc32_z(0, in.data(), in.size()));
    for (int byte = 3; byte >= 0; --byte) out.push_back(static_cast<std::uint8_t>(sum >> (8 * byte)));
    const Inflated back = by_zlib(out);
    INFO("content " << i);
    REQUIRE(back.verdict == Verdict::ended);
    REQUIRE((back.bytes == in));
  }
}
