// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the inflater of our own gives the verdict of zlib, and where the stream is no damaged one the same
// bytes and the same rest. The first two bytes say in what pieces it is given its input and its room.
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image/files/plain_inflate.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most = std::size_t{1} << 22;
  if (size < 3) return 0;
  const std::size_t piece = data[0] + 1U;
  std::vector<std::uint8_t> room(data[1] * 16U + 1U), ours, theirs, taken(65536);
  data += 2;
  size -= 2;

  z_stream z{};
  inflateInit2(&z, 15);
  z.next_in = const_cast<Bytef*>(data);
  z.avail_in = static_cast<uInt>(size);
  int code = Z_OK;
  while (code == Z_OK && theirs.size() < most) {
    z.next_out = taken.data();
    z.avail_out = static_cast<uInt>(taken.size());
    code = inflate(&z, Z_NO_FLUSH);
    theirs.insert(theirs.end(), taken.data(), z.next_out);
  }
  const std::size_t behind = z.avail_in;
  inflateEnd(&z);
  if (code == Z_OK) return 0;

  PlainInflater inflater;
  PlainInflater::Status status{};
  std::size_t at = 0;
  while (true) {
    std::size_t written = 0;
    status = inflater.read(room, written);
    ours.insert(ours.end(), room.begin(), room.begin() + static_cast<std::ptrdiff_t>(written));
    if (status == PlainInflater::Status::more) continue;
    if (status != PlainInflater::Status::hungry || at == size) break;
    const std::size_t count = std::min(piece, size - at);
    inflater.feed({data + at, count});
    at += count;
  }
  // The end of a stream that breaks off may hide that it is a damaged one from either of the two.
  if (code == Z_BUF_ERROR || status == PlainInflater::Status::hungry) {
    assert(code != Z_STREAM_END && status != PlainInflater::Status::ended);
    return 0;
  }
  assert((code == Z_STREAM_END) == (status == PlainInflater::Status::ended));
  if (code != Z_STREAM_END) return 0;
  assert(ours == theirs);
  assert(inflater.unused() + size - at == behind);
  return 0;
}
