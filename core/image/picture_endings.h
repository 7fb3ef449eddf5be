// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/base/text/ascii.h"

namespace etak {

/// The endings of file names that etak takes for textures, without the dot and in lower case. The format of a
/// file is told by its first bytes (picture_bytes.h).
inline constexpr std::array<std::string_view, 11> picture_endings{"png", "tif",  "tiff", "exr", "jpg", "jpeg",
                                                                  "tga", "webp", "bmp",  "dds", "ktx2"};

/// Endings of pictures that etak does not read.
inline constexpr std::array<std::string_view, 16> unread_picture_endings{
    "psd",  "psb", "gif",   "jp2", "j2k",  "jxl", "avif", "heic",
    "heif", "ktx", "basis", "pvr", "astc", "tx",  "kra",  "xcf"};

/// The ending of a path without its dot and in lower case; empty where the file's name has none, or is all ending.
inline std::string path_ending(std::string_view path) {
  const std::size_t dot = path.rfind('.'), name = path.rfind('/') + 1;  // npos + 1 is 0
  return dot == path.npos || dot <= name ? "" : lower_case(path.substr(dot + 1));
}

/// The path without that ending and its dot.
inline std::string_view without_ending(std::string_view path) {
  const std::size_t ending = path_ending(path).size();
  return ending == 0 ? path : path.substr(0, path.size() - ending - 1);
}

inline bool has_picture_ending(std::string_view path) {
  return std::ranges::find(picture_endings, path_ending(path)) != picture_endings.end();
}
inline bool has_unread_picture_ending(std::string_view path) {
  return std::ranges::find(unread_picture_endings, path_ending(path)) != unread_picture_endings.end();
}

/// The ending of Radiance files, which etak takes for light of an environment and not for textures.
inline constexpr std::string_view radiance_ending = "hdr";

}  // namespace etak
