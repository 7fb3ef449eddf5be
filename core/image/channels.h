// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace etak {

/// The two textures of an atlas, RGBA with 8 bits each.
///   diffuse_alpha    A: diffuse colour, sRGB-encoded, and alpha
///   specular_gloss   B: F0, sRGB-encoded, and gloss
enum class Texture { diffuse_alpha, specular_gloss };
inline constexpr std::array both_textures{Texture::diffuse_alpha, Texture::specular_gloss};
std::string_view name(Texture texture);  // "diffuse_alpha", "specular_gloss"

/// The eight numbers of a texel: diffuse r g b, alpha, specular r g b, gloss.
inline constexpr std::size_t channel_count = 8;
inline constexpr std::size_t alpha_channel = 3, specular_channel = 4, gloss_channel = 7;
inline constexpr std::array<std::string_view, channel_count> channel_names{
    "diffuse_r", "diffuse_g", "diffuse_b", "alpha", "specular_r", "specular_g", "specular_b", "gloss"};

/// First of the four channels of a texture.
constexpr std::size_t first_channel(Texture texture) {
  return texture == Texture::diffuse_alpha ? 0 : 4;
}

/// The least and the largest code of every channel over some texels; least above most: over none.
struct ChannelRange {
  std::array<std::uint8_t, channel_count> least, most;
  bool grey = true;  // red, green and blue of F0 are equal in every texel

  ChannelRange() {
    least.fill(255);
    most.fill(0);
  }
  bool constant(std::size_t channel) const { return least[channel] >= most[channel]; }
  /// All four of the texture.
  bool constant(Texture texture) const {
    const std::size_t first = first_channel(texture);
    return constant(first) && constant(first + 1) && constant(first + 2) && constant(first + 3);
  }
  int varying() const {
    int count = 0;
    for (std::size_t c = 0; c < channel_count; ++c) count += constant(c) ? 0 : 1;
    return count;
  }
  void add(const ChannelRange& other) {
    for (std::size_t c = 0; c < channel_count; ++c) {
      least[c] = std::min(least[c], other.least[c]);
      most[c] = std::max(most[c], other.most[c]);
    }
    grey = grey && other.grey;
  }
  friend bool operator==(const ChannelRange&, const ChannelRange&) = default;
};

/// Adds `count` RGBA texels to one texture's half of a range.
void add_texels(ChannelRange& range, Texture texture, const std::uint8_t* rgba, std::size_t count);

}  // namespace etak
