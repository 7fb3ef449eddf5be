// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace etak {

// The built-in material library: the bytes of encode_library(materials/**.json, resources/unmeasured.json) as
// 64-bit words of the machine that the program is for, in an array that any C++ compiler takes. The source is
// written by etak_embed during the build.
extern const std::uint64_t library_words[];
extern const std::size_t library_bytes;  // the last word may hold more

}  // namespace etak
