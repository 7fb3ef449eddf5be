// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace etak {

// What can be said of a picture file by looking at its bytes, before a decoder sees them.

/// OpenImageIO's name of the format ("png", "jpeg", "webp", "openexr", "hdr", "tiff", ...) by the first
/// bytes, for Targa, which begins with nothing of its own, by the ending of `name`; "" when neither says.
std::string picture_format(std::string_view bytes, std::string_view name);

/// Whether compressing changed the values.
///   bytes         of the whole file (looked at for WebP, which knows both)
///   format        as above
///   compression   as OpenImageIO names it: "dwaa", "jpeg", "DXT1", "zip", ...
bool is_lossy(std::string_view bytes, std::string_view format, std::string_view compression);

/// Throws Error that names `label` for a file that ends too early or, where the format has checksums, is
/// damaged: decoders of these formats fill up what they do not find. Says nothing of formats it does not
/// know.
void check_whole(std::string_view bytes, std::string_view format, std::string_view label);

}  // namespace etak
