// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/image/picture.h"

namespace etak {

/// One texel in place of a picture of one colour: samplers find the same wherever they look, in every mip.
///   rgba   its values, as RowSource has them
///   file   a PNG file of the texel, in as many channels as the picture has
///   name   for the file: the same for the same texel
struct OneTexel {
  PictureHeader header;
  std::array<std::uint8_t, 4> rgba{};
  std::string file, name;
};

/// Reads rows of 8 bits until they have two colours. nullopt for these, and for a picture that is one texel
/// already.
std::optional<OneTexel> one_texel_of(RowSource& rows);

}  // namespace etak
