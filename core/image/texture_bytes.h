// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/image/picture.h"

namespace etak {

/// The memory that a texture takes on a GPU without block compression. Grey takes one value a texel, grey
/// with alpha two, and three channels take as much as four, since GPUs have no format of three 8-bit
/// channels.
///   mips      true: all levels down to 1 x 1; false: level 0 alone
///   returns   bytes; a value takes header.bits / 8 of them
std::uint64_t texture_bytes(const PictureHeader& header, bool mips);

}  // namespace etak
