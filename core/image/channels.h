// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace etak {

/// The two textures of an atlas: RGBA, 8 bits a channel.
///   diffuse_alpha    texture A: the diffuse colour, sRGB-encoded, and alpha
///   specular_gloss   texture B: F0, sRGB-encoded, and gloss
enum class Texture { diffuse_alpha, specular_gloss };
inline constexpr std::array both_textures{Texture::diffuse_alpha, Texture::specular_gloss};
std::string_view name(Texture texture);  // "diffuse_alpha", "specular_gloss"

/// A texel of both textures is eight numbers, in this order: diffuse r g b, alpha, specular r g b, gloss.
inline constexpr std::size_t channel_count = 8;
inline constexpr std::size_t alpha_channel = 3, specular_channel = 4, gloss_channel = 7;
inline constexpr std::array<std::string_view, channel_count> channel_names{
    "diffuse_r", "diffuse_g", "diffuse_b", "alpha", "specular_r", "specular_g", "specular_b", "gloss"};

/// Index of the first of the four channels of a texture.
constexpr std::size_t first_channel(Texture texture) {
  return texture == Texture::diffuse_alpha ? 0 : 4;
}

/// The least and the largest code of every channel over a set of texels. Over no texels, every `least` is 255
/// and every `most` is 0.
struct ChannelRange {
  std::array<std::uint8_t, channel_count> least, most;
  bool grey = true;  // red, green and blue of F0 are equal in every texel

  ChannelRange() {
    least.fill(255);
    most.fill(0);
  }
  bool constant(std::size_t channel) const { return least[channel] >= most[channel]; }
  /// Whether all four channels of the texture are constant.
  bool constant(Texture texture) const {
    const std::size_t first = first_channel(texture);
    return constant(first) && constant(first + 1) && constant(first + 2) && constant(first + 3);
  }
  /// How many of the eight channels vary.
  int varying() const {
    int count = 0;
    for (std::size_t c = 0; c < channel_count; ++c) count += constant(c) ? 0 : 1;
    return count;
  }
  /// Extends the range by the texels that `other` was taken over.
  void add(const ChannelRange& other) {
    for (std::size_t c = 0; c < channel_count; ++c) {
      least[c] = std::min(least[c], other.least[c]);
      most[c] = std::max(most[c], other.most[c]);
    }
    grey = grey && other.grey;
  }
  friend bool operator==(const ChannelRange&, const ChannelRange&) = default;
};

/// Extends the four channels of `texture` in `range` by `count` RGBA texels of that texture.
void add_texels(ChannelRange& range, Texture texture, const std::uint8_t* rgba, std::size_t count);

}  // namespace etak
