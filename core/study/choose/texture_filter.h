// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/color/gloss.h"
#include "core/image/channels.h"
#include "core/image/pixels_view.h"
#include "core/math/mat3.h"

namespace etak {

// A material's texture pair as a renderer reads it, for the choice of a texture filter.

/// Ways to read a texture pair, the cheapest first.
///   constant      no texture: one number for each channel, the mean
///   nearest       one texel of level 0
///   bilinear      four texels of level 0
///   nearest_mip   four texels of the nearer mip
///   trilinear     four texels of two mips
enum class TextureFilter { constant, nearest, bilinear, nearest_mip, trilinear };
inline constexpr std::array all_filters{TextureFilter::constant, TextureFilter::nearest,
                                        TextureFilter::bilinear, TextureFilter::nearest_mip,
                                        TextureFilter::trilinear};
std::string_view name(TextureFilter filter);  // "constant", "nearest", "bilinear", "nearest-mip", "trilinear"
/// Whether the filter reads mips.
constexpr bool reads_mips(TextureFilter filter) {
  return filter == TextureFilter::nearest_mip || filter == TextureFilter::trilinear;
}

/// A texel of both textures, colours in linear light.
struct SurfaceTexel {
  Vec3 diffuse{0, 0, 0}, f0{0.04, 0.04, 0.04};
  Gloss gloss = 0.75;  // Schueler's g, or a roughness
};

/// Both textures with mips: colours are averaged in linear light, gloss by the lobe's variance (1 / e), as
/// the packer does.
class TexelChain {
 public:
  ///   diffuse_alpha, specular_gloss   RGBA codes as the packer has them, equal in size
  ///   box                             the part in use, at least one texel; texels of alpha 0 count as well
  ///   gloss                           the form of the codes of gloss
  TexelChain(const ConstPixelsView8& diffuse_alpha, const ConstPixelsView8& specular_gloss,
             const PixelBox& box, GlossForm gloss);

  int width() const { return levels_[0].width; }
  int height() const { return levels_[0].height; }
  int levels() const { return static_cast<int>(levels_.size()); }
  int varying() const { return varying_; }  // how many of the two textures are not one colour
  bool constant() const { return varying_ == 0; }

  /// The texel that the filter gives at a place.
  ///   x, y    in texels of level 0, whose centres lie at one half; beyond the edges the edge texels repeat
  ///   level   level of detail: the base two logarithm of the pixel's size in texels of level 0
  SurfaceTexel read(TextureFilter filter, double x, double y, double level) const;

  /// Up to `most` different colours of F0, linear, spread over their range of luminance with both ends.
  std::vector<Vec3> some_f0(std::size_t most) const;

  /// The mean texel as the codes of the pair.
  std::array<std::uint8_t, channel_count> mean_codes() const { return mean_codes_; }

 private:
  // The numbers of a texel: diffuse, F0, 1 / e.
  static constexpr std::size_t numbers = 7;
  using Values = std::array<double, numbers>;
  struct Level {
    int width = 0, height = 0;
    std::vector<float> values;
    const float* at(int x, int y) const;
  };
  static Values bilinear(const Level& level, double x, double y);
  static SurfaceTexel texel(const Values& values);

  std::vector<Level> levels_;
  std::vector<std::uint32_t> f0_codes_;  // colours of F0 that occur, in the order of luminance
  std::array<std::uint8_t, channel_count> mean_codes_{};
  int varying_ = 0;
};

}  // namespace etak
