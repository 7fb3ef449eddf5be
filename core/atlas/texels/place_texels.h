// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/atlas/plan.h"
#include "core/atlas/texels/resolution.h"
#include "core/image/dilate.h"
#include "core/image/material_pair.h"
#include "core/image/mips.h"
#include "core/image/pixels_view.h"
#include "core/image/wrap.h"

namespace etak {

// The texels of regions on the levels of a page, four channels each. Value is std::uint8_t (codes) or float:
// pages of both come from these steps. A rotated region is turned by 90 degrees: column c of the picture is
// row c of the page, and the picture's rows run from right to left.

/// Copies `box` of a picture to column x, row y of a page.
template <class Value>
void copy_texels(const std::type_identity_t<PixelsViewOf<const Value>>& picture, const PixelBox& box,
                 const PixelsViewOf<Value>& page, int x, int y, bool rotated) {
  constexpr std::size_t texel = 4 * sizeof(Value);
  if (!rotated) {
    for (int row = 0; row < box.height; ++row)
      std::memcpy(page.at(x, y + row), picture.at(box.x, box.y + row),
                  texel * static_cast<std::size_t>(box.width));
    return;
  }
  for (int row = 0; row < box.height; ++row)
    for (int column = 0; column < box.width; ++column)
      std::memcpy(page.at(x + box.height - 1 - row, y + column), picture.at(box.x + column, box.y + row),
                  texel);
}

/// The picture that copy_texels() put into `box` of a page.
template <class Value>
Pixels<Value> texels_back(const PixelsViewOf<Value>& page, const PixelBox& box, bool rotated) {
  constexpr std::size_t texel = 4 * sizeof(Value);
  Pixels<Value> out(rotated ? box.height : box.width, rotated ? box.width : box.height, 4);
  for (int y = 0; y < box.height; ++y) {
    if (!rotated) {
      std::memcpy(out.at(0, y).data(), page.at(box.x, box.y + y),
                  texel * static_cast<std::size_t>(box.width));
      continue;
    }
    for (int x = 0; x < box.width; ++x)
      std::memcpy(out.at(y, box.width - 1 - x).data(), page.at(box.x + x, box.y + y), texel);
  }
  return out;
}

/// Fills the texels of `cell` around `box` from those in the box: what a sampler reads there that wraps by
/// `wrap` at the edges of the picture in the box.
///   wrap   by axis of the picture
template <class Value>
void fill_gutter(const PixelsViewOf<Value>& page, const PixelBox& box, const PixelBox& cell, WrapBoth wrap,
                 bool rotated) {
  if (box == cell) return;
  if (rotated) std::swap(wrap[0], wrap[1]);
  if (wrap == WrapBoth{Wrap::clamp, Wrap::clamp}) return replicate_edges(page, box, cell);
  for (int y = cell.y; y < cell.y + cell.height; ++y)
    for (int x = cell.x; x < cell.x + cell.width; ++x) {
      const int from_x = box.x + wrapped_texel(x - box.x, box.width, wrap[0]);
      const int from_y = box.y + wrapped_texel(y - box.y, box.height, wrap[1]);
      if (from_x != x || from_y != y) std::memcpy(page.at(x, y), page.at(from_x, from_y), 4 * sizeof(Value));
    }
}

/// Level 0 of a region that has all texels of its box: the box of the picture, and in the gutter what a
/// sampler reads around the box: the picture's own texels, and beyond its edges as it wraps.
///   picture   whole
template <class Value>
void place_picture(const Pixels<Value>& picture, const PixelBox& box, const WrapBoth& wrap,
                   const PlannedPlace& at, const PixelsViewOf<Value>& page) {
  copy_texels(view(picture), box, page, at.x, at.y, at.rotated);
  if (at.gutter == 0) return;
  const auto around = [&](int column, int row) {
    const int x = at.rotated ? at.x + box.height - 1 - row : at.x + column,
              y = at.rotated ? at.y + column : at.y + row;
    std::memcpy(page.at(x, y),
                picture
                    .at(wrapped_texel(box.x + column, picture.width, wrap[0]),
                        wrapped_texel(box.y + row, picture.height, wrap[1]))
                    .data(),
                4 * sizeof(Value));
  };
  for (int row = -at.gutter; row < box.height + at.gutter; ++row)
    for (int column = -at.gutter; column < box.width + at.gutter; ++column)
      if (row < 0 || row >= box.height || column < 0 || column >= box.width) around(column, row);
}

/// A region on a level of its page: its texels, and the cell around them.
struct LevelBoxes {
  PixelBox part, cell;
};
///   width, height             of the region on that level, as it lies on the page
///   page_width, page_height   of the page on that level; both boxes lie inside and hold a texel at least
inline LevelBoxes boxes_at(const PlannedPlace& at, int level, int width, int height, int page_width,
                           int page_height) {
  const auto inside = [&](PixelBox box) {
    box.x = std::min(box.x, page_width - 1);
    box.y = std::min(box.y, page_height - 1);
    box.width = std::clamp(box.width, 1, page_width - box.x);
    box.height = std::clamp(box.height, 1, page_height - box.y);
    return box;
  };
  const int gutter = at.gutter >> level;
  LevelBoxes out;
  out.cell =
      inside({at.cell.x >> level, at.cell.y >> level, at.cell.width >> level, at.cell.height >> level});
  out.part = inside({out.cell.x + gutter, out.cell.y + gutter, width, height});
  return out;
}

/// Levels [first, end) of a region with their gutters.
///   chain   of the region; the last level stands for those beyond it
///   wrap    of the picture in the region
///   page    gives the view of a texture's level; its data is null for a texture that the page lacks
template <class Value, class Page>
void place_levels(const MipPairOf<Value>& chain, const PlannedPlace& at, const WrapBoth& wrap, int first,
                  int end, const Page& page) {
  for (const Texture texture : both_textures)
    for (int l = first; l < end; ++l) {
      const PixelsViewOf<Value> out = page(texture, l);
      if (out.data == nullptr) break;
      const auto& images = chain.of(texture);
      const Pixels<Value>& image = images[std::min(static_cast<std::size_t>(l), images.size() - 1)];
      const auto [part, cell] = boxes_at(at, l, at.rotated ? image.height : image.width,
                                         at.rotated ? image.width : image.height, out.width, out.height);
      copy_texels(view(image),
                  {0, 0, at.rotated ? part.height : part.width, at.rotated ? part.width : part.height}, out,
                  part.x, part.y, at.rotated);
      fill_gutter(out, part, cell, wrap, at.rotated);
    }
}

/// What mips are made with in the place of a texture that the page lacks: opaque, and black of gloss 0.
template <class Value>
Pixels<Value> missing_texture(Texture texture, int width, int height) {
  constexpr Value full = std::is_same_v<Value, float> ? 1 : 255;
  return Pixels<Value>(width, height, 4, texture == Texture::diffuse_alpha ? full : Value{0});
}

/// Levels [first, end) of a page, from its level first - 1 as it is: they mix the texels of neighbours.
///   page   as of place_levels()
template <class Value, class Page>
void make_shared_levels(int first, int end, GlossForm gloss, unsigned threads, const Page& page) {
  std::array<Pixels<Value>, 2> last;
  for (const Texture texture : both_textures)
    if (const PixelsViewOf<Value> from = page(texture, first - 1); from.data != nullptr)
      last[static_cast<std::size_t>(texture)] = texels_back(from, {0, 0, from.width, from.height}, false);
  auto& [a, b] = last;
  if (a.values.empty()) a = missing_texture<Value>(Texture::diffuse_alpha, b.width, b.height);
  if (b.values.empty()) b = missing_texture<Value>(Texture::specular_gloss, a.width, a.height);
  MipOptions options;
  options.levels = end - first + 1;
  const MipPairOf<Value> chain = region_chain(a, b, options, gloss, threads);
  for (const Texture texture : both_textures)
    for (int l = first; l < end; ++l) {
      const PixelsViewOf<Value> out = page(texture, l);
      if (out.data == nullptr) break;
      const Pixels<Value>& image = chain.of(texture)[static_cast<std::size_t>(l - first + 1)];
      copy_texels(view(image), {0, 0, out.width, out.height}, out, 0, 0, false);
    }
}

}  // namespace etak
