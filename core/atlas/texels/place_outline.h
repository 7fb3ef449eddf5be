// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "core/atlas/texels/compose.h"
#include "core/atlas/texels/place_texels.h"

namespace etak {

// The levels of a part of a picture, whose gutters hold what lies around it there: filtering at a level reads up to a texel of that
// level beyond the part. The pieces of an outline have one shift and one grid, so that its levels are made once, of the picture
// around all pieces, and every piece takes its cell of them: where cells overlap they hold the same.

/// Whether the region is such a part. Of a picture that is whole, and of one with fewer texels, the edge is the end.
inline bool has_texels_around(const Region& region, const PackInput& m) {
  return region.outline != 0 ||
         (m.convert && region.shrink == 0 && !region.own_page && !m.is_whole(region.box));
}

/// The pieces of one outline, or a box, and where they lie on their page. Cells begin and end on the grid of all levels that are
/// placed.
struct OutlineOnPage {
  std::span<const Region> pieces;
  std::span<const PlannedPlace> places;

  /// The box of the page that holds all cells.
  PixelBox cells() const {
    PixelBox out = places[0].cell;
    for (const PlannedPlace& place : places) out = around(out, place.cell);
    return out;
  }
  /// The texels of the stored level of the picture for a box of the page, which may lie beyond the picture's edges.
  PixelBox in_picture(const PixelBox& on_page) const {
    const PixelBox box = stored_box(pieces[0]);
    const PlannedPlace& at = places[0];
    if (!at.rotated)
      return {box.x + on_page.x - at.x, box.y + on_page.y - at.y, on_page.width, on_page.height};
    return {box.x + on_page.y - at.y, box.y + at.x + box.height - on_page.x - on_page.width, on_page.height,
            on_page.width};
  }
};

/// A box of a picture and of what a sampler reads beyond its edges.
template <class Value>
Pixels<Value> texels_around(const Pixels<Value>& picture, const PixelBox& box, const WrapBoth& wrap) {
  Pixels<Value> out(box.width, box.height, picture.channels);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x)
      std::ranges::copy(picture.at(wrapped_texel(box.x + x, picture.width, wrap[0]),
                                   wrapped_texel(box.y + y, picture.height, wrap[1])),
                        out.at(x, y).begin());
  return out;
}

/// Beyond the edges at which a picture is clamped a sampler reads the edge of the level that it reads. A mip of the repeated
/// edge of level 0 is another colour.
///   inside   the picture's own texels of level 0 in the chain
template <class Value>
void clamp_levels(std::vector<Pixels<Value>>& levels, PixelBox inside, const WrapBoth& wrap) {
  if (wrap[0] != Wrap::clamp) inside.x = 0, inside.width = levels[0].width;
  if (wrap[1] != Wrap::clamp) inside.y = 0, inside.height = levels[0].height;
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const int step = 1 << l;
    if ((inside.x | inside.y | inside.width | inside.height) % step != 0) break;
    const PixelBox own{inside.x / step, inside.y / step, inside.width / step, inside.height / step};
    if (own.width > 0 && own.height > 0)
      replicate_edges(view(levels[l]), own, {0, 0, levels[l].width, levels[l].height});
  }
}

/// The material and the pictures that a part is taken from.
///   whole     the pictures of its material
///   normals   of the same size; null: none, or not needed
template <class Pair>
struct OutlinePictures {
  const PackInput& material;
  const Pair& whole;
  const Image8* normals = nullptr;
};

/// Levels [0, levels) of a part with their gutters, of which the first is a level of the picture that its regions name.
///   page   as of place_levels()
template <class Pair, class Page>
void place_outline(const OutlineOnPage& outline, const OutlinePictures<Pair>& pictures, int levels,
                   const ComposeOptions& how, const Page& page) {
  const auto& [m, whole, normals] = pictures;
  const int first = outline.pieces[0].shrink;
  const PixelBox cells = outline.cells(), stored = outline.in_picture(cells);
  const PixelBox from{stored.x * (1 << first), stored.y * (1 << first), stored.width << first,
                      stored.height << first};
  auto a = texels_around(whole.diffuse_alpha, from, m.wrap),
       b = texels_around(whole.specular_gloss, from, m.wrap);
  if (how.bleed) bleed_under_alpha(a, b);
  MipOptions options = mip_options(m, first + levels);
  std::optional<Image8> around_here;
  if (normals != nullptr) options.normals = &around_here.emplace(texels_around(*normals, from, m.wrap));
  auto chain = region_chain(a, b, options, how.gloss);
  if (first > 0 && normals != nullptr) {
    // The level that is stored is looked at with its normals; those after it stand for their spread.
    options.levels = first + 1;
    options.normals = nullptr;
    chain.specular_gloss[static_cast<std::size_t>(first)] =
        std::move(region_chain(a, b, options, how.gloss).specular_gloss.back());
  }
  PixelBox inside = common_part(from, {0, 0, m.width, m.height});
  inside.x -= from.x;
  inside.y -= from.y;
  for (const Texture texture : both_textures) {
    clamp_levels(chain.of(texture), inside, m.wrap);
    for (int l = 0; l < levels; ++l) {
      const auto out = page(texture, l);
      if (out.data == nullptr) break;
      const auto& image = chain.of(texture)[static_cast<std::size_t>(first + l)];
      for (const PlannedPlace& place : outline.places) {
        const PixelBox part = outline.in_picture(place.cell);
        copy_texels(view(image),
                    {(part.x - stored.x) >> l, (part.y - stored.y) >> l, part.width >> l, part.height >> l},
                    out, place.cell.x >> l, place.cell.y >> l, place.rotated);
      }
    }
  }
}

}  // namespace etak
