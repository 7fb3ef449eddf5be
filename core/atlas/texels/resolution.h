// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "core/atlas/plan.h"
#include "core/atlas/sources/pictures.h"
#include "core/image/image.h"
#include "core/image/mips.h"

namespace etak {

// Regions may be stored with fewer texels than their pictures have: as one of their higher mips.

/// How far a region with fewer texels is from the one it stands for, at worst, over the texels and the points
/// half way between them, both filtered bilinearly in linear light, diffuse and F0 alike.
struct ResolutionError {
  double delta_e = 0;  // CIEDE2000, and 100 times the difference of alpha and of gloss where that is more
  double codes = 0;    // of 255, of any channel
  friend bool operator==(const ResolutionError&, const ResolutionError&) = default;
};

/// Compares a pair with a smaller one of the same content. Stops early and returns what it has found so far
/// where delta_e exceeds `enough`.
///   looked_at   the texels of `whole` that count
ResolutionError resolution_error(const MaterialPair& whole, const MaterialPair& fewer, const WrapBoth& wrap,
                                 const PixelBox& looked_at, double enough, unsigned threads);

/// The texels of a level that a box of level 0 touches.
PixelBox whole_texels(const PixelBox& box, int level);

/// With how many texels a region is stored.
struct Resolution {
  int shrink = 0;         // the level that is stored
  ResolutionError seen;   // against the level that can be seen at most (level 0 without `unseen`)
  ResolutionError whole;  // against level 0
};

/// How far a region's texels may be halved.
///   mask      its alpha is tested. Where that varies the region stays as it is beyond `unseen`: a small difference of
///             alpha is a large one of what is seen
///   unseen    halvings that cost nothing that can be seen
///   bound     of Resolution::seen.delta_e for halvings beyond those; none: there are no others
struct ResolutionLimits {
  bool mask = false;
  int unseen = 0;
  std::optional<double> bound = {};
};

/// The fewest texels for a region.
///   levels    the mip chain of the region, level 0 first, as deep as the result may go
///   looked_at   the texels of level 0 that count
Resolution resolution_of(const MipPair& levels, const ResolutionLimits& limits, const WrapBoth& wrap,
                         const PixelBox& looked_at, unsigned threads);

/// Mips of a region, as mip_pair() makes them, for gloss in any form. A roughness is averaged as the squared
/// width of its lobe, to which the normals add twice their variance s2 = (1 - |N|) / |N|:
/// alpha^2 = mean(alpha^2) + 2 s2 (Beckmann slopes; Olano and Baker 2010, with Toksvig's 2005 estimate of the
/// variance).
template <class Value>
MipPairOf<Value> region_chain(const Pixels<Value>& a, const Pixels<Value>& b, MipOptions options,
                              GlossForm gloss, unsigned threads = 1);

/// What mips of a material's texels are made with: so many levels, and alpha as the material tests it.
MipOptions mip_options(const PackInput& material, int levels);

/// A part of a material's two pictures.
///   a, b   the texels of `box` in them
template <class Value>
struct PairPart {
  const PackInput& material;
  const PixelBox& box;
  const Pixels<Value>&a, &b;
};

/// Mips of such a part from level `first` on, `levels` of them; of those after that one the gloss is lowered by the
/// spread of the material's normals. A chain that ends earlier gives fewer, but its last level always.
template <class Value>
MipPairOf<Value> levels_from(int first, int levels, const PairPart<Value>& part, GlossForm gloss,
                             unsigned threads = 1);

/// The region as it is stored at level 0, without its gutter.
///   pair   of the whole material
MaterialPair stored_pair(const MaterialPair& pair, const Region& region, const PackInput& material,
                         GlossForm gloss);

}  // namespace etak
