// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/image/picture.h"

namespace etak {

/// The bytes that a texture takes on a GPU without block compression: grey is one value a texel, grey with
/// alpha two, and three channels take the room of four, since GPUs have no format of three 8-bit channels.
///   mips      with all levels down to 1 x 1; else level 0 alone
///   returns   bytes; values of 16 and 32 bits take two and four times those of 8
std::uint64_t texture_bytes(const PictureHeader& header, bool mips);

}  // namespace etak
