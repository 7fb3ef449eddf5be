// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace etak {

/// The endings of file names that etak takes for textures, without the dot and in lower case. The format of a
/// file is told by its first bytes (picture_bytes.h).
inline constexpr std::array<std::string_view, 8> picture_endings{"png", "tif",  "tiff", "exr",
                                                                 "jpg", "jpeg", "tga",  "webp"};

/// The ending of Radiance files, which etak takes for light of an environment and not for textures.
inline constexpr std::string_view radiance_ending = "hdr";

}  // namespace etak
