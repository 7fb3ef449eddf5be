// SPDX-License-Identifier: Apache-2.0
// Writes and reads DDS files. Based on Microsoft's "Programming Guide for DDS" (DDS_HEADER, DDS_PIXELFORMAT,
// DDS_HEADER_DXT10).
#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/bytes/bytes_le.h"
#include "core/base/error.h"
#include "core/image/files/containers.h"
#include "core/image/mips.h"

namespace etak {
namespace {

using namespace bytes_le;

constexpr std::size_t header_end = 4 + 124, dx10_end = header_end + 20;
constexpr std::uint32_t flag_caps = 0x1, flag_height = 0x2, flag_width = 0x4, flag_pitch = 0x8,
                        flag_pixel_format = 0x1000, flag_mip_count = 0x20000, flag_linear_size = 0x80000;
constexpr std::uint32_t pixel_alpha = 0x1, pixel_four_cc = 0x4, pixel_rgb = 0x40;
constexpr std::uint32_t caps_complex = 0x8, caps_texture = 0x1000, caps_mipmap = 0x400000;
constexpr std::uint32_t caps2_cube_or_volume = 0x200 | 0xfc00 | 0x200000;
constexpr std::uint32_t dxgi_r8g8b8a8_unorm = 28, dxgi_r8g8b8a8_unorm_srgb = 29;
constexpr std::uint32_t texture_2d = 3, misc_cube = 0x4;
constexpr std::uint32_t alpha_straight = 1, alpha_premultiplied = 2, alpha_custom = 4;
constexpr std::array<std::uint32_t, 4> rgba_masks{0xff, 0xff00, 0xff0000, 0xff000000};

// The names of formats in blocks under the headers of Direct3D 9. DXT2 and DXT4 are BC2 and BC3 with colours
// multiplied by alpha.
struct FourCc {
  std::string_view name;
  std::uint32_t dxgi;
};
constexpr std::array four_ccs{FourCc{"DXT1", 71}, FourCc{"DXT2", 74}, FourCc{"DXT3", 74},
                              FourCc{"DXT4", 77}, FourCc{"DXT5", 77}, FourCc{"ATI1", 80},
                              FourCc{"BC4U", 80}, FourCc{"ATI2", 83}, FourCc{"BC5U", 83}};

// The format of the texels; `known` is false for those that are not read.
struct Format {
  bool known = false, srgb = false, dx10 = false;
  const BlockFormat* blocks = nullptr;
};

// The caller has looked whether a whole header of its kind is there.
Format format_of(std::string_view bytes) {
  Format out;
  if ((number32(bytes, 80) & pixel_four_cc) == 0) {
    out.known = number32(bytes, 88) == 32;
    for (std::size_t c = 0; c < rgba_masks.size(); ++c)
      out.known = out.known && number32(bytes, 92 + 4 * c) == rgba_masks[c];
    return out;
  }
  const std::string_view name = bytes.substr(84, 4);
  out.dx10 = name == "DX10";
  if (out.dx10 && bytes.size() >= dx10_end) {
    const std::uint32_t dxgi = number32(bytes, 128);
    out.blocks = block_format_of_dxgi(dxgi);
    out.known = out.blocks != nullptr || dxgi == dxgi_r8g8b8a8_unorm || dxgi == dxgi_r8g8b8a8_unorm_srgb;
    out.srgb = out.blocks != nullptr ? dxgi == out.blocks->dxgi_srgb : dxgi == dxgi_r8g8b8a8_unorm_srgb;
  }
  for (const FourCc& each : four_ccs)
    if (each.name == name) out.blocks = block_format_of_dxgi(each.dxgi);
  out.known = out.known || out.blocks != nullptr;
  return out;
}

void write_levels(std::span<const TextureLevel> levels, const BlockFormat* blocks, bool srgb,
                  bool custom_alpha, DdsHeader header, const FileSink& sink) {
  assert(!levels.empty());
  const TextureLevel& first = levels[0];
  const bool mips = levels.size() > 1, dx10 = header == DdsHeader::dx10;
  std::string out("DDS ");
  append32(out, 124);
  const bool texels = blocks == nullptr || blocks->code == BlockCode::r8;
  append32(out, flag_caps | flag_height | flag_width | (texels ? flag_pitch : flag_linear_size) |
                    flag_pixel_format | (mips ? flag_mip_count : 0));
  append32(out, static_cast<std::uint64_t>(first.height));
  append32(out, static_cast<std::uint64_t>(first.width));
  // The bytes of a row; of blocks those of the first level.
  append32(out, texels ? texture_level_bytes(blocks, first.width, 1) : first.bytes.size());
  append32(out, 0);  // no depth
  append32(out, levels.size());
  out.append(std::size_t{11} * 4, '\0');
  append32(out, 32);  // pixel format
  append32(out, dx10 ? pixel_four_cc : pixel_rgb | pixel_alpha);
  out += dx10 ? std::string_view("DX10") : std::string_view("\0\0\0\0", 4);
  append32(out, dx10 ? 0 : 32);
  for (const std::uint32_t mask : rgba_masks) append32(out, dx10 ? 0 : mask);
  append32(out, caps_texture | (mips ? caps_complex | caps_mipmap : 0));
  out.append(std::size_t{4} * 4, '\0');
  if (dx10) {
    append32(out, blocks != nullptr ? (srgb ? blocks->dxgi_srgb : blocks->dxgi)
                                    : (srgb ? dxgi_r8g8b8a8_unorm_srgb : dxgi_r8g8b8a8_unorm));
    append32(out, texture_2d);
    append32(out, 0);
    append32(out, 1);  // one layer
    append32(out, custom_alpha ? alpha_custom : alpha_straight);
  }
  sink.add(out);
  for (const TextureLevel& level : levels) sink.add(level.bytes);
}

}  // namespace

void write_dds(std::span<const TextureLevel> levels, const BlockFormat* blocks, bool srgb, bool custom_alpha,
               const FileSink& sink) {
  write_levels(levels, blocks, srgb, custom_alpha, DdsHeader::dx10, sink);
}

void write_dds(std::span<const ConstPixelsView8> levels, bool srgb, bool custom_alpha, DdsHeader header,
               const FileSink& sink) {
  if (header == DdsHeader::legacy && srgb)
    throw Error::at("DDS", "an sRGB texture under a legacy header", "a DX10 header, which can say sRGB");
  write_levels(texture_levels(levels), nullptr, srgb, custom_alpha, header, sink);
}

bool has_known_dds_format(std::string_view bytes) {
  return bytes.size() >= header_end && format_of(bytes).known;
}

TextureFile read_dds(std::string_view bytes, std::string_view path) {
  const auto expect = [&](bool good, std::string_view what, std::uint64_t value, std::string_view expected) {
    if (!good) throw Error::at(path, std::string(what) + ' ' + std::to_string(value), expected);
  };
  const auto u32 = [&](std::size_t at) { return number32(bytes, at); };
  if (bytes.substr(0, 4) != "DDS ") throw Error::at(path, "no DDS signature", "a DDS file");
  expect(bytes.size() >= header_end, "a header of bytes", bytes.size(), "128 at least");
  expect(u32(4) == 124, "header size", u32(4), "124");
  expect(u32(76) == 32, "pixel format size", u32(76), "32");
  const std::uint32_t height = u32(12), width = u32(16);
  for (const std::uint32_t side : {width, height})
    expect(side >= 1 && side <= max_image_side, "side", side, "1 to " + std::to_string(max_image_side));
  expect((u32(112) & caps2_cube_or_volume) == 0, "caps2", u32(112), "a 2-D texture, no cube or volume");

  TextureFile file;
  std::size_t at = header_end;
  const Format format = format_of(bytes);
  file.blocks = format.blocks;
  file.srgb = format.srgb;
  if (format.dx10) {
    expect(bytes.size() >= dx10_end, "a DX10 header of bytes", bytes.size() - header_end, "20");
    at = dx10_end;
    const std::uint32_t alpha = u32(144) & 7;
    expect(
        format.known, "DXGI format", u32(128),
        "R8G8B8A8 (28, 29), R8 (61), BC1 (71, 72), BC2 (74, 75), BC3 (77, 78), BC4 (80), BC5 (83), BC6H (95, 96) or BC7 (98, 99)");
    expect(u32(132) == texture_2d, "resource dimension", u32(132), "3: a 2-D texture");
    expect((u32(136) & misc_cube) == 0, "misc flags", u32(136), "no cube map");
    expect(u32(140) == 1, "layers", u32(140), "1");
    expect(alpha != alpha_premultiplied && alpha <= alpha_custom, "alpha mode", alpha,
           "0 (unknown), 1 (straight), 3 (opaque) or 4 (custom)");
    file.custom_alpha = alpha == alpha_custom;
  } else if ((u32(80) & pixel_four_cc) != 0) {
    const std::string_view name = bytes.substr(84, 4);
    if (!format.known || name == "DXT2" || name == "DXT4")
      throw Error::at(path, "format " + in_quotes(name),
                      "DX10, DXT1, DXT3, DXT5, ATI1 or ATI2, or 32-bit RGBA masks");
  } else {
    expect((u32(80) & pixel_rgb) != 0 && (u32(80) & pixel_alpha) != 0 && u32(88) == 32, "pixel format flags",
           u32(80), "DX10 or 32-bit RGBA masks");
    for (std::size_t c = 0; c < rgba_masks.size(); ++c)
      expect(u32(92 + 4 * c) == rgba_masks[c], "bit mask", u32(92 + 4 * c), std::to_string(rgba_masks[c]));
  }

  const auto full =
      static_cast<std::uint32_t>(full_mip_levels(static_cast<int>(width), static_cast<int>(height)));
  const std::uint32_t count =
      (u32(8) & flag_mip_count) != 0 || (u32(108) & caps_mipmap) != 0 ? std::max(1u, u32(28)) : 1;
  expect(count <= full, "levels", count, "at most " + std::to_string(full));
  const auto side = [](std::uint32_t of, std::uint32_t level) {
    return std::max(1, static_cast<int>(of >> level));
  };
  std::size_t size = 0;
  for (std::uint32_t l = 0; l < count; ++l)
    size += texture_level_bytes(file.blocks, side(width, l), side(height, l));
  expect(bytes.size() - at == size, "texels of bytes", bytes.size() - at, std::to_string(size));
  for (std::uint32_t l = 0; l < count; ++l) {
    const int level_width = side(width, l), level_height = side(height, l);
    const std::size_t length = texture_level_bytes(file.blocks, level_width, level_height);
    add_level(file, {level_width, level_height, bytes.substr(at, length)});
    at += length;
  }
  return file;
}

}  // namespace etak
