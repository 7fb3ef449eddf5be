// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/image.h"
#include "core/image/pixels_view.h"

namespace etak {

/// Where a file goes that is never whole in memory: bytes one behind the other, and some put over earlier
/// ones.
struct FileSink {
  std::function<void(std::string_view)> add;
  std::function<void(std::size_t at, std::string_view)> patch;
};

/// A KTX 2.0 file (Khronos KTX 2.0 specification): VK_FORMAT_R8G8B8A8_UNORM or _SRGB with its data format
/// descriptor, straight alpha, KTXorientation "rd", KTXwriter "etak".
///   levels       an RGBA8 texture with its mip chain: levels[l] has max(1, side >> l) texels a side, 4
///                channels, rows without gaps between them
///   srgb         the colour is sRGB-encoded; alpha never is
///   zstd_level   0: no supercompression; 1..22: Zstandard
void write_ktx2(std::span<const ConstPixelsView8> levels, bool srgb, int zstd_level, const FileSink& sink);

/// How a DDS file says what it holds.
///   dx10     DXGI_FORMAT_R8G8B8A8_UNORM or _UNORM_SRGB, with the alpha mode
///   legacy   bit masks of Direct3D 9 (A8B8G8R8): no word on sRGB or on alpha, but older readers know it
///            (OpenImageIO 2.4 refuses RGBA8 under a DX10 header and reads this one)
enum class DdsHeader { dx10, legacy };

/// A DDS file, level 0 first, rows without padding; alpha mode straight for colour + alpha and custom for the
/// rest.
///   levels, srgb   as above
///   custom_alpha   the fourth channel is not an opacity (gloss); DX10 only
///   header         legacy cannot say sRGB: throws Error for such a texture
void write_dds(std::span<const ConstPixelsView8> levels, bool srgb, bool custom_alpha, DdsHeader header,
               const FileSink& sink);

/// For programs that load an atlas: reads back what the two above write (and other uncompressed RGBA8 files
/// of these kinds: 2-D, one layer, one face, alpha not premultiplied). Sizes, level counts and places are
/// checked before anything is allocated. Throws Error.
struct TextureFile {
  std::vector<Image8> levels;
  bool srgb = true;
  bool custom_alpha = false;  // DDS with a DX10 header only
};
TextureFile read_ktx2(std::string_view bytes, std::string_view path);
TextureFile read_dds(std::string_view bytes, std::string_view path);

}  // namespace etak
