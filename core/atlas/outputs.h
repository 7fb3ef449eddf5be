// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/atlas/layout.h"
#include "core/image/files/png.h"

namespace etak {

class OutputFolder;
class PagePixels;
struct BlockFormat;  // core/image/blocks/blocks.h

/// What page textures are written as: "png" (mips in files of their own), "ktx2" and "dds" (mips inside); as
/// floats "tiff" and "exr" (mips in files of their own).
inline constexpr std::array<std::string_view, 5> page_formats{"png", "ktx2", "dds", "tiff", "exr"};
constexpr bool holds_floats(std::string_view format) {
  return format == "tiff" || format == "exr";
}

/// How the pages of an atlas are written.
struct WriteOptions {
  std::vector<std::string> formats{"png"};
  std::optional<PngLevel> png_level = PngLevel::fast;  // none: weighed for each picture (png_level_for())
  int zstd_level = 0;                                  // of ktx2
  unsigned threads = 1;
  // Called from any thread with the number of texels of level 0 that were just written as PNG.
  std::function<void(std::size_t texels)> written = {};
};

/// A texture in blocks, level by level.
///   levels         the first ones; where some are missing, they are RGBA8 in files of their own
///   fourth_apart   the blocks hold colour alone, and the fourth channel is as it is, in files of R8
struct TextureInBlocks {
  const BlockFormat* format = nullptr;
  std::vector<std::string> levels;  // bytes
  bool fourth_apart = false;
};

/// Whether some format holds floats.
bool writes_floats(const WriteOptions& options);

/// "page0_diffuse_alpha.png"; mips of PNG: "page0_diffuse_alpha.mip1.png".
std::string page_file(int page, Texture texture, std::string_view format, int level = 0);

/// The files that write_page() makes for a texture, in its order.
std::vector<std::string> page_files(int page, Texture texture, int levels,
                                    const std::vector<std::string>& formats);

/// Whether some format holds textures as a GPU reads them, in which they may be compressed.
bool writes_containers(const WriteOptions& options);

/// Writes one texture of a page, in those of the formats that hold codes.
///   blocks   what KTX2 and DDS files hold in place of the texels; null: RGBA8. A fourth channel apart is written by
///            write_fourth(), and levels that are not in the blocks by write_tail()
void write_page(OutputFolder& folder, int page, Texture texture, const PagePixels& pixels,
                const WriteOptions& options, const TextureInBlocks* blocks = nullptr);
void write_fourth(OutputFolder& folder, int page, Texture texture, const PagePixels& pixels,
                  const WriteOptions& options);
///   first   the first level that is written
void write_tail(OutputFolder& folder, int page, Texture texture, const PagePixels& pixels, int first,
                const WriteOptions& options);

}  // namespace etak
