// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

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
struct MipPair {
  std::vector<Image8> diffuse_alpha, specular_gloss;
  std::size_t gloss_clamped = 0;  // texels of levels 1 and on whose lobe is wider than gloss 0 (e < 1)
};

/// 8 bits. Colours are averaged in linear light and rounded half up once, at the end of each level, from the
/// level above kept as floats; gloss g of exponent e = 2^(12 g) by the mean of 1/e, weighted by F0's
/// luminance (where that is 0 everywhere: plain mean). Colours under different alphas are weighted by alpha.
/// Coverage (share of 4 x 4 bilinear samples between each four texel centres with alpha >= cutoff) is brought
/// back by a factor of the level's own unscaled alpha, so that levels do not depend on each other's factor;
/// colours are weighted by unscaled alpha.
///   a, b      4 channels, of one size
///   threads   never changes the result
///   error     against the same in double from level 0: at most 1 code (without alpha_cutoff, whose factor
///             2^(k/256) is found on the stored codes)
MipPair mip_pair(const Image8& a, const Image8& b, const MipOptions& options, unsigned threads = 1);

/// The same into pictures that somebody else holds: level l to to_a[l] and to_b[l], which have its size; [0]
/// is not touched and may be the input. options.levels is at most to_a.size().
///   returns   MipPair::gloss_clamped
std::size_t mip_levels(const ConstPixelsView8& a, const ConstPixelsView8& b, const MipOptions& options,
                       unsigned threads, std::span<const PixelsView8> to_a,
                       std::span<const PixelsView8> to_b);

/// The same for float pictures: colours linear, alpha and gloss plain. What is not finite stays so.
///   error   relative 1e-5 against double
struct MipPairFloat {
  std::vector<Image> diffuse_alpha, specular_gloss;
};
MipPairFloat mip_pair(const Image& a, const Image& b, const MipOptions& options, unsigned threads = 1);

/// Number of levels of a full chain.
int full_mip_levels(int width, int height);

/// Colour of texels of alpha 0 from the nearest visible ones (pull-push), all channels of A but alpha, and B.
/// Texels with alpha above 0 do not change. Returns how many were filled. More in dilate.h.
std::size_t bleed_under_alpha(Image8& a, Image8& b);

}  // namespace etak
