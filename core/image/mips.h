// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/image/channels.h"
#include "core/image/image.h"
#include "core/image/pixels_view.h"

namespace etak {

// Mip chains of one region of a texture pair, made from that region alone.
//   texture A   diffuse RGB, sRGB-encoded, and alpha
//   texture B   specular RGB (F0), sRGB-encoded, and gloss
// Level l has max(1, floor(side / 2^l)) texels a side. Odd sides use polyphase box weights: each new texel is
// the mean over the area it covers, so content does not shift.
//
// Based on
//   gloss      Toksvig 2005, "Mipmapping Normal Maps": e' = |N| e / (|N| + e (1 - |N|)), which is
//              1/e' = 1/e + (1 - |N|) / |N|, so variances add and their mean is what a chain must keep
//   slopes     Olano and Baker 2010, "LEAN Mapping", with one variance for both axes
//   coverage   Castano 2010, "Computing Alpha Mipmaps"

/// What a normal map's spread adds to the lobe's variance 1/e.
///   toksvig   (1 - |N|) / |N|, N the mean of the unit normals
///   slopes    (var p + var q) / 2 of the slopes p = x/z, q = y/z (z at least 1/64)
/// Both are sigma^2 where slopes vary by a small sigma along each axis.
enum class NormalVariance { toksvig, slopes };

/// How each texel's weight in its mean is found and what is kept.
struct MipOptions {
  // Diffuse under alpha 0 does not count (where all alphas are 0: plain mean).
  bool alpha_weights_diffuse = true;
  // MASK materials: alpha of each level is scaled so that the share of texels that pass the cutoff stays that
  // of level 0.
  std::optional<double> alpha_cutoff;
  // Tangent-space normal map of the region's size, RGB 8 bit (a fourth channel is ignored): its variance
  // lowers the gloss of levels 1 and on.
  const Image8* normals = nullptr;
  NormalVariance normal_variance = NormalVariance::toksvig;
  int levels = 0;  // including level 0; 0: down to 1 x 1
};

/// Levels of the pair; [0] is the input.
template <class Value>
struct MipPairOf {
  std::vector<Pixels<Value>> diffuse_alpha, specular_gloss;
  // Of codes: texels of levels 1 and on whose lobe is wider than gloss 0 (e < 1).
  std::size_t gloss_clamped = 0;
  std::vector<Pixels<Value>>& of(Texture texture) {
    return texture == Texture::diffuse_alpha ? diffuse_alpha : specular_gloss;
  }
  const std::vector<Pixels<Value>>& of(Texture texture) const {
    return texture == Texture::diffuse_alpha ? diffuse_alpha : specular_gloss;
  }
};
using MipPair = MipPairOf<std::uint8_t>;
using MipPairFloat = MipPairOf<float>;

/// Value is std::uint8_t or float, whose colours are linear and whose alpha and gloss are plain; what is not
/// finite stays so.
/// Codes: colours are averaged in linear light and rounded half up once, at the end of each level, from the
/// level above kept as floats; gloss g of exponent e = 2^(12 g) by the mean of 1/e, weighted by F0's
/// luminance (where that is 0 everywhere: plain mean). Colours under different alphas are weighted by alpha.
/// Coverage (share of 4 x 4 bilinear samples between each four texel centres with alpha >= cutoff) is brought
/// back by a factor of the level's own unscaled alpha, so that levels do not depend on each other's factor;
/// colours are weighted by unscaled alpha.
///   a, b      4 channels, of one size
///   threads   never changes the result
///   error     against the same in double from level 0: at most 1 code (without alpha_cutoff, whose factor
///             2^(k/256) is found on the stored codes); of floats relative 1e-5
template <class Value>
MipPairOf<Value> mip_pair(const Pixels<Value>& a, const Pixels<Value>& b, const MipOptions& options,
                          unsigned threads = 1);

/// The same into pictures that somebody else holds: level l to to_a[l] and to_b[l], which have its size; [0]
/// is not touched and may be the input. options.levels is at most to_a.size().
///   returns   MipPair::gloss_clamped
std::size_t mip_levels(const ConstPixelsView8& a, const ConstPixelsView8& b, const MipOptions& options,
                       unsigned threads, std::span<const PixelsView8> to_a,
                       std::span<const PixelsView8> to_b);

/// Number of levels of a full chain.
int full_mip_levels(int width, int height);

}  // namespace etak
