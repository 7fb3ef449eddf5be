// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace etak {

/// How the names of pictures end that etak takes for textures, without dot and in lower case. What a file
/// holds is told by its first bytes (picture_bytes.h).
inline constexpr std::array<std::string_view, 8> picture_endings{"png", "tif",  "tiff", "exr",
                                                                 "jpg", "jpeg", "tga",  "webp"};

/// Radiance pictures, which are light of an environment.
inline constexpr std::string_view radiance_ending = "hdr";

}  // namespace etak
