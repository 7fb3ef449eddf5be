// SPDX-License-Identifier: Apache-2.0
// Writes and reads KTX 2.0 files. Based on the KTX File Format Specification 2.0 and, for the descriptor, the
// Khronos Data Format Specification 1.3. This is the only source of etak that uses Zstandard.
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>

#ifdef ETAK_HAS_ZSTD
#include <zstd.h>
#endif
#include "core/base/bytes/bytes_le.h"
#include "core/base/error.h"
#include "core/image/files/containers.h"
#include "core/image/mips.h"

namespace etak {
namespace {

using namespace bytes_le;

constexpr std::string_view identifier("\xabKTX 20\xbb\r\n\x1a\n", 12);
constexpr std::uint32_t vk_r8g8b8a8_unorm = 37, vk_r8g8b8a8_srgb = 43;
constexpr std::uint32_t scheme_none = 0, scheme_zstd = 2;
#ifndef ETAK_HAS_ZSTD
constexpr const char* without_zstd = "Zstandard, which this etak was built without";
#endif
constexpr std::size_t header_bytes = 80, index_entry_bytes = 24;  // the level index follows the header

// Levels that are not compressed lie on multiples of so many bytes.
std::size_t unit_bytes(const BlockFormat* blocks) {
  return std::max<std::size_t>(4, blocks != nullptr ? blocks->block_bytes : 4);
}

void pad_to_4(std::string& out) {
  while (out.size() % 4 != 0) out.push_back('\0');
}

// A sample of a data format descriptor: the bits of a texel block that hold a channel.
struct Sample {
  unsigned first_bit, bits, channel;
  std::uint32_t most;       // the code that stands for 1; of floats their bits
  std::uint32_t least = 0;  // that stands for 0, or for -1 of floats with a sign
};
constexpr unsigned alpha_channel = 15, linear_sample = 0x10, signed_sample = 0x40, float_sample = 0x80;

// The samples of a format (Khronos Data Format Specification 1.3, tables of the compressed formats).
std::vector<Sample> samples_of(const BlockFormat* blocks) {
  if (blocks == nullptr)
    return {{0, 8, 0, 255}, {8, 8, 1, 255}, {16, 8, 2, 255}, {24, 8, alpha_channel, 255}};
  constexpr std::uint32_t all = 0xffffffff;
  switch (blocks->code) {
    case BlockCode::bc2:
    case BlockCode::bc3:
      return {{0, 64, alpha_channel, all}, {64, 64, 0, all}};
    case BlockCode::bc5:
      return {{0, 64, 0, all}, {64, 64, 1, all}};
    case BlockCode::r8:
      return {{0, 8, 0, 255}};
    case BlockCode::bc1:
      return {{0, 64, blocks->channels == 4 ? 1u : 0u, all}};  // 1: with transparent texels
    case BlockCode::bc6h:
      return {{0, 128, float_sample, 0x3f800000}};
    case BlockCode::bc6h_signed:
      return {{0, 128, float_sample | signed_sample, 0x3f800000, 0xbf800000}};
    default:
      return {{0, static_cast<unsigned>(8 * blocks->block_bytes), 0, all}};
  }
}

// The number of the colour model of a format: 1 is RGB with alpha.
std::uint64_t colour_model(const BlockFormat* blocks) {
  if (blocks == nullptr || blocks->code == BlockCode::r8) return 1;
  constexpr std::uint64_t bc1 = 128, astc = 162;
  if (blocks->code == BlockCode::astc) return astc;
  return bc1 + static_cast<std::uint64_t>(holds_floats(blocks) ? BlockCode::bc6h : blocks->code);
}

// The basic data format descriptor. Its transfer function is that of the colour; where that is sRGB, the sample
// of the alpha channel is marked as linear.
//   blocks   null for RGBA8
std::string data_format_descriptor(const BlockFormat* blocks, bool srgb) {
  constexpr std::uint64_t primaries_bt709 = 1, transfer_linear = 1, transfer_srgb = 2;
  const std::vector<Sample> samples = samples_of(blocks);
  const std::uint64_t block_bytes = 24 + 16 * samples.size();
  std::string out;
  append32(out, 4 + block_bytes);
  append32(out, 0);                      // vendor Khronos, basic descriptor
  append32(out, 2 | block_bytes << 16);  // version 1.3
  append(out, colour_model(blocks), 1);
  append(out, primaries_bt709, 1);
  append(out, srgb ? transfer_srgb : transfer_linear, 1);
  append(out, 0, 1);  // straight alpha
  // The sides of a texel block, each less 1: 1 x 1 x 1 x 1, or those of a block.
  append(out, blocks == nullptr ? 0 : static_cast<std::uint64_t>(blocks->block_width - 1), 1);
  append(out, blocks == nullptr ? 0 : static_cast<std::uint64_t>(blocks->block_height - 1), 1);
  append(out, 0, 2);
  // The bytes of a texel block in plane 0, also with supercompression (where older revisions wanted 0).
  append64(out, blocks == nullptr ? 4 : blocks->block_bytes);
  for (const Sample& sample : samples) {
    const bool linear = srgb && sample.channel == alpha_channel;
    append(out, sample.first_bit, 2);
    append(out, sample.bits - 1, 1);
    append(out, sample.channel | (linear ? linear_sample : 0), 1);
    append32(out, 0);  // sample position
    append32(out, sample.least);
    append32(out, sample.most);
  }
  return out;
}

// The key/value data: sorted by key, each value with its final zero.
std::string key_values() {
  std::string out;
  for (const std::string_view pair :
       {std::string_view("KTXorientation\0rd\0", 18), std::string_view("KTXwriter\0etak\0", 15)}) {
    append32(out, pair.size());
    out += pair;
    pad_to_4(out);
  }
  return out;
}

#ifdef ETAK_HAS_ZSTD
// Compresses bytes to one Zstandard frame, which goes to `add` piece by piece; returns the length of the
// frame.
std::size_t compress(std::string_view bytes, int level, const std::function<void(std::string_view)>& add) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  const auto checked = [](std::size_t result) {
    if (ZSTD_isError(result) != 0) throw Error::at("KTX2", ZSTD_getErrorName(result), "Zstandard to work");
    return result;
  };
  checked(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level));
  checked(ZSTD_CCtx_setPledgedSrcSize(context.get(), bytes.size()));
  std::string piece(ZSTD_CStreamOutSize(), '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t length = 0, left = 1;
  while (left != 0) {
    ZSTD_outBuffer out{piece.data(), piece.size(), 0};
    left = checked(ZSTD_compressStream2(context.get(), &out, &in, ZSTD_e_end));
    add(std::string_view(piece).substr(0, out.pos));
    length += out.pos;
  }
  return length;
}
#else
std::size_t compress(std::string_view, int, const std::function<void(std::string_view)>&) {
  throw Error::at("KTX2", without_zstd, "level 0: no compression");
}
#endif

struct Reader {
  std::string_view bytes, path;

  [[noreturn]] void fail(std::string_view found, std::string_view expected) const {
    throw Error::at(path, found, expected);
  }
  void expect(bool good, std::string_view what, std::uint64_t value, std::string_view expected) const {
    if (!good) fail(std::string(what) + ' ' + std::to_string(value), expected);
  }
  std::uint32_t u32(std::size_t at) const { return number32(bytes, at); }

  // A part of the file, which must not begin before offset `first`, where the level index ends.
  std::string_view part(std::string_view what, std::uint64_t offset, std::uint64_t length,
                        std::size_t first) const {
    if (offset < first || offset > bytes.size() || length > bytes.size() - offset)
      fail(
          std::string(what) + " at " + std::to_string(offset) + ", " + std::to_string(length) + " bytes long",
          "a place between " + std::to_string(first) + " and the end of the file, " +
              std::to_string(bytes.size()));
    return bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
  }

  void check_descriptor(std::string_view found, const BlockFormat* blocks, bool srgb,
                        bool supercompressed) const {
    const std::string expected = data_format_descriptor(blocks, srgb);
    // The primaries may be unspecified, and bytesPlane0 is 0 in supercompressed files of older revisions.
    constexpr std::size_t primaries_at = 13, plane_at = 20;
    std::string same(found);
    if (same.size() == expected.size()) {
      if (same[primaries_at] == 0) same[primaries_at] = expected[primaries_at];
      if (supercompressed && same[plane_at] == 0) same[plane_at] = expected[plane_at];
      constexpr std::size_t flags_at = 15;
      if ((static_cast<unsigned char>(same[flags_at]) & 1) != 0)
        fail("premultiplied alpha", "straight alpha");
    }
    if (same != expected)
      fail(
          "a data format descriptor that is not that of the Vulkan format",
          std::string(blocks != nullptr ? blocks->name : "R8G8B8A8") + (srgb                   ? "_SRGB's"
                                                                        : holds_floats(blocks) ? "'s"
                                                                                               : "_UNORM's"));
  }

  // Only the orientation matters: a picture stored from the bottom would be read upside down.
  void check_key_values(std::string_view data) const {
    for (std::size_t at = 0; at < data.size();) {
      if (data.size() - at < 4) fail("key/value data that break off", "whole entries");
      const std::size_t length = number32(data, at);
      at += 4;
      if (length > data.size() - at) fail("key/value data that break off", "whole entries");
      const std::string_view pair = data.substr(at, length);
      const std::size_t end = pair.find('\0');
      if (end == pair.npos || end == 0) fail("a key/value pair without a key", "key, zero, value");
      std::string_view value = pair.substr(end + 1);
      while (!value.empty() && value.back() == '\0') value.remove_suffix(1);
      if (pair.substr(0, end) == "KTXorientation" && value != "rd")
        fail("KTXorientation " + in_quotes(value), "\"rd\": columns to the right, rows down");
      at += std::min(data.size() - at, (length + 3) / 4 * 4);
    }
  }

#ifdef ETAK_HAS_ZSTD
  void decompress(std::string_view from, std::string& to) const {
    const std::size_t size = ZSTD_decompress(to.data(), to.size(), from.data(), from.size());
    if (ZSTD_isError(size) != 0)
      fail(std::string("Zstandard data: ") + ZSTD_getErrorName(size), "a whole frame");
    expect(size == to.size(), "Zstandard data of uncompressed size", size, std::to_string(to.size()));
  }
#else
  void decompress(std::string_view, std::string&) const {
    fail(without_zstd, "no compression");
  }
#endif
};

// Adds a level's texels; ASTC is decoded by the functions that the program has for it.
void add_level(TextureFile& file, const TextureLevel& level, const AstcDoor& astc, std::string_view path) {
  if (file.blocks == nullptr || file.blocks->code != BlockCode::astc) return add_level(file, level);
  if (!astc.decode)
    throw Error::at(path, "is in ASTC, which needs a decoder of pictures", "BC1 to BC7, or RGBA8");
  file.levels.push_back(
      astc.decode(level.bytes, {file.blocks, file.srgb}, level.width, level.height, std::string(path)));
}

}  // namespace

bool has_zstd() {
#ifdef ETAK_HAS_ZSTD
  return true;
#else
  return false;
#endif
}

void add_level(TextureFile& file, const TextureLevel& level) {
  if (holds_floats(file.blocks))
    file.floats.push_back(float_level_of(level.bytes, *file.blocks, level.width, level.height));
  else
    file.levels.push_back(level_of(level.bytes, file.blocks, level.width, level.height));
}

std::vector<TextureLevel> texture_levels(std::span<const ConstPixelsView8> levels) {
  std::vector<TextureLevel> out;
  for (const ConstPixelsView8& level : levels) {
    assert(level.channels == 4 && level.stride == 4 * static_cast<std::size_t>(level.width));
    out.push_back({level.width,
                   level.height,
                   {reinterpret_cast<const char*>(level.data),
                    texture_level_bytes(nullptr, level.width, level.height)}});
  }
  return out;
}

void write_ktx2(std::span<const TextureLevel> levels, const BlockFormat* blocks, bool srgb, int zstd_level,
                const FileSink& sink) {
  assert(!levels.empty() && zstd_level >= 0 && zstd_level <= 22);
  const TextureLevel& first = levels[0];
  const std::size_t count = levels.size();
  const std::string descriptor = data_format_descriptor(blocks, srgb);
  std::string pairs = key_values();
  const std::size_t descriptor_at = header_bytes + index_entry_bytes * count;
  const std::size_t pairs_at = descriptor_at + descriptor.size(), pairs_bytes = pairs.size();
  // Levels that are not compressed lie on multiples of 4 bytes and of a block.
  if (zstd_level == 0)
    while ((pairs_at + pairs.size()) % unit_bytes(blocks) != 0) pairs.push_back('\0');

  // Lengths are whole units but for those of R8.
  const auto padded = [&](std::size_t bytes) {
    const std::size_t unit = unit_bytes(blocks);
    return (bytes + unit - 1) / unit * unit;
  };
  // The smallest level comes first, so that a reader may stop early; the index begins with the largest. The
  // lengths of compressed levels are patched in when they are known.
  std::vector<std::size_t> offset(count), length(count);
  std::size_t end = pairs_at + pairs.size();
  for (std::size_t l = count; l-- > 0;) {
    [[maybe_unused]] const TextureLevel& level = levels[l];
    assert(level.width == std::max(1, first.width >> l) && level.height == std::max(1, first.height >> l) &&
           level.bytes.size() == texture_level_bytes(blocks, level.width, level.height));
    length[l] = levels[l].bytes.size();
    offset[l] = end;
    end += padded(length[l]);
  }
  const auto index = [&] {
    std::string out;
    for (std::size_t l = 0; l < count; ++l) {
      append64(out, offset[l]);
      append64(out, length[l]);
      append64(out, levels[l].bytes.size());
    }
    return out;
  };

  std::string out(identifier);
  append32(out, blocks != nullptr ? (srgb ? blocks->vk_srgb : blocks->vk)
                                  : (srgb ? vk_r8g8b8a8_srgb : vk_r8g8b8a8_unorm));
  append32(out, 1);  // bytes of a typed unit
  append32(out, static_cast<std::uint64_t>(first.width));
  append32(out, static_cast<std::uint64_t>(first.height));
  append32(out, 0);  // no depth
  append32(out, 0);  // no layers
  append32(out, 1);  // one face
  append32(out, count);
  append32(out, zstd_level > 0 ? scheme_zstd : scheme_none);
  append32(out, descriptor_at);
  append32(out, descriptor.size());
  append32(out, pairs_at);
  append32(out, pairs_bytes);
  append64(out, 0);  // no global data
  append64(out, 0);
  assert(out.size() == header_bytes);
  sink.add(out + index() + descriptor + pairs);
  if (zstd_level == 0) {
    for (std::size_t l = count; l-- > 0;) {
      sink.add(levels[l].bytes);
      if (padded(length[l]) > length[l]) sink.add(std::string(padded(length[l]) - length[l], '\0'));
    }
    return;
  }
  end = pairs_at + pairs.size();
  for (std::size_t l = count; l-- > 0;) {
    offset[l] = end;
    length[l] = compress(levels[l].bytes, zstd_level, sink.add);
    end += length[l];
  }
  sink.patch(header_bytes, index());
}

void write_ktx2(std::span<const ConstPixelsView8> levels, bool srgb, int zstd_level, const FileSink& sink) {
  write_ktx2(texture_levels(levels), nullptr, srgb, zstd_level, sink);
}

TextureFile read_ktx2(std::string_view bytes, std::string_view path, const AstcDoor& astc) {
  const Reader r{bytes, path};
  if (bytes.substr(0, identifier.size()) != identifier) r.fail("no KTX 2.0 identifier", "a KTX 2.0 file");
  if (bytes.size() < header_bytes) r.fail("a header that breaks off", "80 bytes");
  const std::uint32_t format = r.u32(12), scheme = r.u32(44);
  const BlockFormat* blocks = block_format_of_vk(format);
  r.expect(
      blocks != nullptr || format == vk_r8g8b8a8_unorm || format == vk_r8g8b8a8_srgb, "Vulkan format", format,
      "9 (R8), 37 or 43 (R8G8B8A8), 131 to 138 (BC1 to BC3), 139 (BC4), 141 (BC5), 143 or 144 (BC6H), 145 or 146 (BC7) or 157 to 172 (ASTC)");
  r.expect(r.u32(16) == 1, "typeSize", r.u32(16), "1");
  const std::uint32_t width = r.u32(20), height = r.u32(24);
  for (const std::uint32_t side : {width, height})
    r.expect(side >= 1 && side <= max_image_side, "side", side, "1 to " + std::to_string(max_image_side));
  r.expect(r.u32(28) == 0, "depth", r.u32(28), "0: a 2-D texture");
  r.expect(r.u32(32) == 0, "layers", r.u32(32), "0: no array");
  r.expect(r.u32(36) == 1, "faces", r.u32(36), "1: no cube map");
  const auto full =
      static_cast<std::uint32_t>(full_mip_levels(static_cast<int>(width), static_cast<int>(height)));
  r.expect(r.u32(40) <= full, "levels", r.u32(40), "at most " + std::to_string(full));
  const std::size_t count = std::max<std::size_t>(1, r.u32(40));  // 0 asks the reader to make the mips itself
  r.expect(scheme == scheme_none || scheme == scheme_zstd, "supercompression scheme", scheme,
           "0 (none) or 2 (Zstandard)");
  r.expect(number64(bytes, 72) == 0, "supercompression global data of bytes", number64(bytes, 72), "none");
  const std::size_t behind_index = header_bytes + index_entry_bytes * count;
  if (bytes.size() < behind_index) r.fail("a level index that breaks off", std::to_string(count) + " levels");
  const bool srgb = blocks != nullptr ? format == blocks->vk_srgb : format == vk_r8g8b8a8_srgb;
  r.check_descriptor(r.part("data format descriptor", r.u32(48), r.u32(52), behind_index), blocks, srgb,
                     scheme == scheme_zstd);
  if (r.u32(60) != 0) r.check_key_values(r.part("key/value data", r.u32(56), r.u32(60), behind_index));

  TextureFile file;
  file.srgb = srgb;
  file.blocks = blocks;
  const std::size_t unit = unit_bytes(blocks);
  const auto side = [](std::uint32_t of, std::size_t level) {
    return std::max(1, static_cast<int>(of >> level));
  };
  std::vector<std::string_view> data;
  for (std::size_t l = 0; l < count; ++l) {
    const std::size_t at = header_bytes + index_entry_bytes * l;
    const std::string name = "level " + std::to_string(l);
    const std::size_t size = texture_level_bytes(blocks, side(width, l), side(height, l));
    data.push_back(r.part(name, number64(bytes, at), number64(bytes, at + 8), behind_index));
    r.expect(number64(bytes, at + 16) == size, name + " of uncompressed bytes", number64(bytes, at + 16),
             std::to_string(size));
    if (scheme == scheme_none) {
      r.expect(data[l].size() == size, name + " of bytes", data[l].size(), std::to_string(size));
      r.expect(number64(bytes, at) % unit == 0, name + " at", number64(bytes, at),
               "a multiple of " + std::to_string(unit));
    } else {
      // A block of Zstandard is at least 4 bytes and holds at most 128 KiB, so a small file cannot ask for
      // much memory.
      r.expect(size / 32768 <= data[l].size(), name + " of compressed bytes", data[l].size(),
               "enough for " + std::to_string(size));
    }
  }
  for (std::size_t l = 0; l < count; ++l) {
    std::string plain;
    if (scheme == scheme_zstd) {
      plain.resize(texture_level_bytes(blocks, side(width, l), side(height, l)));
      r.decompress(data[l], plain);
    }
    const std::string_view texels = scheme == scheme_zstd ? plain : data[l];
    add_level(file, {side(width, l), side(height, l), texels}, astc, path);
  }
  return file;
}

}  // namespace etak
