// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/blocks/astc_door.h"
#include "core/image/blocks/blocks.h"
#include "core/image/image.h"
#include "core/image/pixels_view.h"

namespace etak {

/// The output of writers whose file is never whole in memory.
///   add     appends bytes to the file
///   patch   overwrites earlier bytes, from offset `at` on
struct FileSink {
  std::function<void(std::string_view)> add;
  std::function<void(std::size_t at, std::string_view)> patch;
};

/// One mip level as a file holds it: rows of texels without gaps between them, or blocks.
///   bytes   texture_level_bytes() of the format and the size
struct TextureLevel {
  int width = 0, height = 0;
  std::string_view bytes;
};

/// The levels of an RGBA8 texture: 4 channels, and no gaps between rows.
std::vector<TextureLevel> texture_levels(std::span<const ConstPixelsView8> levels);

/// Writes a KTX 2.0 file (Khronos KTX 2.0 specification) of RGBA8 or of blocks, with its data format descriptor,
/// straight alpha, KTXorientation "rd", KTXwriter "etak".
///   levels       a texture with its mip chain: levels[l] has max(1, side >> l) texels a side
///   blocks       null: RGBA8
///   srgb         the colour is sRGB-encoded; alpha never is. Of a format that has such a number
///   zstd_level   0: no supercompression; 1..22: Zstandard, an Error where has_zstd() is false
void write_ktx2(std::span<const TextureLevel> levels, const BlockFormat* blocks, bool srgb, int zstd_level,
                const FileSink& sink);
/// Writes levels of RGBA8 as KTX2.
void write_ktx2(std::span<const ConstPixelsView8> levels, bool srgb, int zstd_level, const FileSink& sink);
/// Whether etak was built with Zstandard.
bool has_zstd();

/// The kind of header of a DDS file.
///   dx10     names DXGI_FORMAT_R8G8B8A8_UNORM or _UNORM_SRGB, and the alpha mode
///   legacy   has bit masks of Direct3D 9 (A8B8G8R8), which tell neither sRGB nor the alpha mode, but which
///            older readers know (OpenImageIO 2.4 refuses RGBA8 under a DX10 header and reads this one)
enum class DdsHeader { dx10, legacy };

/// Writes a DDS file, level 0 first, rows without padding. Throws Error for an sRGB texture with a legacy
/// header, which cannot say sRGB.
///   levels, blocks, srgb   as in write_ktx2(); blocks have a DX10 header
///   custom_alpha   true: the fourth channel is no opacity (but gloss), and the alpha mode is "custom";
///                  false: the alpha mode is "straight". Only DX10 headers have an alpha mode
void write_dds(std::span<const TextureLevel> levels, const BlockFormat* blocks, bool srgb, bool custom_alpha,
               const FileSink& sink);
/// Writes levels of RGBA8 as DDS.
void write_dds(std::span<const ConstPixelsView8> levels, bool srgb, bool custom_alpha, DdsHeader header,
               const FileSink& sink);

/// A texture that was read from a KTX2 or DDS file.
struct TextureFile {
  std::vector<Image8> levels;
  std::vector<Image> floats;            // the levels in place of these where holds_floats(blocks)
  const BlockFormat* blocks = nullptr;  // the format of the file, one of block_formats; null for RGBA8
  bool srgb = true;
  bool custom_alpha = false;  // set by DDS files with a DX10 header only
};

/// Decodes a level of any format but ASTC, and adds it to those of a file.
void add_level(TextureFile& file, const TextureLevel& level);

/// For programs that load an atlas: these read the files that write_ktx2() and write_dds() make, other
/// uncompressed RGBA8 files of these formats, and textures in the formats of block_formats, decoded (2-D, one
/// layer, one face, alpha not premultiplied; KTX2 also with Zstandard, DDS of blocks also under the headers of
/// Direct3D 9, which do not tell sRGB). Sizes, level counts and offsets are checked before memory is allocated.
/// They throw Error that names `path`.
///   astc   decodes ASTC; such files are refused where it is empty
TextureFile read_ktx2(std::string_view bytes, std::string_view path, const AstcDoor& astc = {});
TextureFile read_dds(std::string_view bytes, std::string_view path);
/// Whether the header of a DDS file names RGBA8 or a format of block_formats, the forms that read_dds() reads.
bool has_known_dds_format(std::string_view bytes);

}  // namespace etak
