// SPDX-License-Identifier: Apache-2.0
#include "core/image/channels.h"

#include <cstring>

namespace etak {

std::string_view name(Texture texture) {
  return texture == Texture::diffuse_alpha ? "diffuse_alpha" : "specular_gloss";
}

namespace {

// Whether red, green and blue are equal in every texel.
bool is_grey(const std::uint8_t* rgba, std::size_t count) {
  std::uint8_t different = 0;
  for (std::size_t i = 0; i < 4 * count; i += 4)
    different = static_cast<std::uint8_t>(different | (rgba[i] ^ rgba[i + 1]) | (rgba[i] ^ rgba[i + 2]));
  return different == 0;
}

}  // namespace

void add_texels(ChannelRange& range, Texture texture, const std::uint8_t* rgba, std::size_t count) {
  // Sixteen texels are compared side by side, in plain loops that the compiler turns into vector
  // instructions.
  constexpr std::size_t lanes = 64;
  std::uint8_t least[lanes], most[lanes];
  std::memset(least, 255, lanes);
  std::memset(most, 0, lanes);
  const std::size_t bytes = 4 * count, whole = bytes - bytes % lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::uint8_t v = rgba[i + lane];
      least[lane] = v < least[lane] ? v : least[lane];
      most[lane] = v > most[lane] ? v : most[lane];
    }
  for (std::size_t i = whole; i < bytes; ++i) {
    least[i % 4] = std::min(least[i % 4], rgba[i]);
    most[i % 4] = std::max(most[i % 4], rgba[i]);
  }
  if (texture == Texture::specular_gloss && range.grey) range.grey = is_grey(rgba, count);
  const std::size_t first = first_channel(texture);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t c = first + lane % 4;
    range.least[c] = std::min(range.least[c], least[lane]);
    range.most[c] = std::max(range.most[c], most[lane]);
  }
}

}  // namespace etak
