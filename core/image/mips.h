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

// Mip chains of one region of a pair of textures, made from the texels of that region alone.
//   texture A   diffuse RGB, sRGB-encoded, and alpha
//   texture B   specular RGB (F0), sRGB-encoded, and gloss
// Level l has max(1, floor(side / 2^l)) texels a side. Odd sides use polyphase box weights: each new texel is
// the mean over the area that it covers, so that the content does not shift.
//
// Based on
//   gloss      Toksvig 2005, "Mipmapping Normal Maps": e' = |N| e / (|N| + e (1 - |N|)), which is
//              1/e' = 1/e + (1 - |N|) / |N|: variances add, so a chain must average 1/e
//   slopes     Olano and Baker 2010, "LEAN Mapping", with one variance for both axes
//   coverage   Castano 2010, "Computing Alpha Mipmaps"

/// How the spread of the normals that a texel covers widens the lobe: what is added to its variance 1/e.
///   toksvig   (1 - |N|) / |N|, N the mean of the unit normals
///   slopes    (var p + var q) / 2 of the slopes p = x/z, q = y/z (z at least 1/64)
/// Both give sigma^2 where the slopes along each axis have a small standard deviation sigma.
enum class NormalVariance { toksvig, slopes };

/// How a mip chain weights texels, which properties of level 0 it keeps, and how long it is.
struct MipOptions {
  // Diffuse colours are weighted by alpha, so that those under alpha 0 do not count. Where all alphas are 0,
  // the plain mean is taken.
  bool alpha_weights_diffuse = true;
  // For materials of alpha mode MASK: the alpha of each level is scaled so that the share of the surface that
  // passes this cutoff stays that of level 0.
  std::optional<double> alpha_cutoff;
  // A tangent-space normal map of the region's size, 8-bit RGB (a fourth channel is ignored), whose variance
  // lowers the gloss of the levels from 1 on; null: none.
  const Image8* normals = nullptr;
  NormalVariance normal_variance = NormalVariance::toksvig;
  int levels = 0;  // how many, level 0 among them; 0: all down to 1 x 1
};

/// The levels of both textures; level 0 is a copy of the input.
template <class Value>
struct MipPairOf {
  std::vector<Pixels<Value>> diffuse_alpha, specular_gloss;
  // For codes: how many texels of the levels from 1 on have a lobe wider than that of gloss 0 (e < 1), and
  // were stored as gloss 0.
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

/// The mip chain of a pair of textures. Colours are averaged in linear light, weighted by alpha. Gloss g,
/// whose exponent is e = 2^(12 g), is averaged as 1/e, weighted by the luminance of F0 (plain mean where that
/// is 0 everywhere). Each level is made from the floats of the next finer one, and codes are rounded half up
/// once.
///
/// Coverage is the share of 4 x 4 bilinear samples between each four texel centres whose alpha is at least
/// the cutoff. It is restored by a factor on the unscaled alpha of each level, so that no level depends on
/// the factor of another; colours are weighted by unscaled alpha.
///   Value     std::uint8_t; or float, with linear colours and with alpha and gloss as they are (values that
///             are not finite stay so)
///   a, b      4 channels, of one size
///   threads   never changes the result
///   error     of codes, against the same computed in double from level 0: at most 1 code (without
///             alpha_cutoff, whose factor 2^(k/256) is found on the stored codes); of floats: relative 1e-5
template <class Value>
MipPairOf<Value> mip_pair(const Pixels<Value>& a, const Pixels<Value>& b, const MipOptions& options,
                          unsigned threads = 1);

/// Makes the levels in pictures of the caller: level l goes to to_a[l] and to_b[l], which must have the
/// size of that level. to_a[0] and to_b[0] are not written and may be the input.
///   options   options.levels is at most to_a.size()
///   returns   MipPair::gloss_clamped
std::size_t mip_levels(const ConstPixelsView8& a, const ConstPixelsView8& b, const MipOptions& options,
                       unsigned threads, std::span<const PixelsView8> to_a,
                       std::span<const PixelsView8> to_b);

/// Number of levels from level 0 down to 1 x 1.
int full_mip_levels(int width, int height);

}  // namespace etak
