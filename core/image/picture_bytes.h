// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace etak {

// What the bytes of a picture file tell before a decoder sees them.

/// OpenImageIO's name of a file's format ("png", "jpeg", "webp", "openexr", "hdr", "tiff", ...), or "ktx2". It is told
/// by the first bytes; Targa files, which have no signature, are told by the ending of `name`. Empty for
/// unknown formats.
std::string picture_format(std::string_view bytes, std::string_view name);

/// Whether the compression of the file changed the values.
///   bytes         the whole file; read for WebP only, which can be lossy or lossless
///   format        as picture_format() names it
///   compression   as OpenImageIO names it: "dwaa", "jpeg", "DXT1", "zip", ...
bool is_lossy(std::string_view bytes, std::string_view format, std::string_view compression);

struct StatedSize {
  std::size_t width = 0, height = 0;  // pixels
};

/// The size that the head of a GIF, BMP or WebP file states, read before a decoder sees the file: the decoders of
/// these formats take memory for the whole picture as soon as they open it. Empty for other formats and for heads
/// that end too early.
std::optional<StatedSize> stated_size(std::string_view bytes, std::string_view format);

/// Throws Error that names `label` for a size outside of 1 to max_image_side pixels on a side.
void check_size(const StatedSize& size, std::string_view label);

/// Throws Error that names `label` for a PNG, JPEG or WebP file that ends too early or, where the format has
/// checksums (PNG), is damaged: the decoders of these formats fill up missing data without an error. Throws, too,
/// where stated_size() is not one that etak reads, or is more than a GIF file of so many bytes can fill.
void check_whole(std::string_view bytes, std::string_view format, std::string_view label);

}  // namespace etak
