// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/row_runs.h"
#include "core/scene/material_uses.h"

namespace etak {

/// Which texels of a width x height texture the triangles of some uses touch.
struct TexelUse {
  int width = 0, height = 0;
  // No common shift brings all triangles into [0,1] (up to half a texel), by periods along an axis whose sampler wraps
  // and none along one that clamps: the whole texture is in use.
  bool tiles = false;
  // Each triangle by itself lies in one period, though not all in the same: `tiles` can be undone by
  // rewriting UVs (AtlasMaterial::islands do).
  bool foldable = true;
  // Brings UVs (after the texture's own transform) into [0,1]: whole periods are taken away, mirrored ones
  // turned over. The identity where nothing is to be shifted, or `tiles`.
  UvTransform fold;
  // x, y, width, height of what is touched inside the texture, bilinear footprint included; whole when
  // `tiles`
  std::array<int, 4> box{0, 0, 0, 0};
  // The box before wrapping or clamping, after `fold`: where it leaves the texture the sampler's wrap
  // supplies the texels, and a gutter must hold them. Up to one texel unless `tiles` or the sampler clamps.
  // Bounded by +-2^29.
  std::array<int, 4> extent{0, 0, 0, 0};
  // 1 per touched texel (conservative: any overlap of the bilinear footprint). Triangles that leave the
  // texture mark the texels to which wrapping leads. Where only the footprint crosses a border, by up to
  // half a texel, and not the triangle, the texels beyond are in `extent` alone.
  std::vector<std::uint8_t> mask;
  std::size_t touched = 0;
  // Per triangle: first and last column and row of its footprint (left, top, right, bottom) after folding,
  // cut to the texture. Empty unless `foldable`.
  std::vector<std::array<std::int16_t, 4>> footprints;
  // Per triangle a texel that it reads, column and row: the one at its centre. As many as footprints.
  std::vector<std::array<std::int16_t, 2>> centres;
};

/// Rasterises conservatively: no texel that bilinear filtering at level 0 can read is missed, of lines and points
/// neither. Triangles without the texture's UV set, or whose set is morphed, and sets beyond the second count as
/// touching everything. A triangle over
/// more than four periods counts as touching everything too. Throws Error for UVs that are NaN or beyond
/// +-1e6.
TexelUse texel_use(const MaterialUses& uses, int material, const GltfTexture& texture, int width, int height);
/// The texels that a material uses, for few materials of a scene: goes through all uses of the scene.
TexelUse texel_use(const GltfScene& scene, int material, const GltfTexture& texture, int width, int height);

/// The texels that samplers read, 1 each: those of the mask and, where only footprints cross a border, those beyond it to
/// which wrapping leads.
std::vector<std::uint8_t> texels_read(const TexelUse& use, const GltfSampler& sampler);

/// The footprint of one triangle, as texel_use() sees it.
struct Footprint {
  std::array<int, 4> texels{0, 0, 0, 0};  // left, top, right, bottom, cut to the texture
  std::array<int, 2> centre{0, 0};        // column and row of the texel at the triangle's centre
  UvTransform fold;                       // brings the triangle into [0,1]
};
/// `uv`: after the texture's own transform. None when the triangle does not lie in one period.
std::optional<Footprint> footprint_of(const std::array<Uv, 3>& uv, const GltfSampler& sampler, int width,
                                      int height);

/// A box of a texture.
struct Island {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const Island&, const Island&) = default;
};

/// Boxes that hold what the triangles touch, of little area in sum: every footprint grown by `margin` (inside
/// the texture) lies in at least one box. A box more is worth it when it saves `merge_cost` texels. Charts
/// are cut where that pays, and boxes may overlap: every triangle is to be looked up in the smallest box that
/// holds its footprint, and finds all the texels there that it reads. In order of y, then x.
///   `use` without footprints gives its box, grown by the margin.
std::vector<Island> islands(const TexelUse& use, int margin, std::size_t merge_cost);

/// An island and those of its texels that belong to it. Others in its box may belong to other islands.
struct Outline {
  Island box;
  RowRuns texels;  // of the texture
  friend bool operator==(const Outline&, const Outline&) = default;
};

/// The islands of each connected part of the mask by itself: an island has the texels of its part in its box. Every
/// triangle is to be looked up in the smallest box that holds its footprint and whose texels hold the triangle's
/// centre, and finds all the texels there that it reads. Sorted as islands(); none without footprints.
std::vector<Outline> outlines(const TexelUse& use, std::size_t merge_cost);

}  // namespace etak
