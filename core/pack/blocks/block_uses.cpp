// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/block_uses.h"

#include <algorithm>

#include "core/atlas/texels/page_pixels.h"

namespace etak {
namespace {

// Columns and rows of a level, cut to it: [left, right) and [top, bottom).
struct LevelBox {
  int left, top, right, bottom;
};

LevelBox at_level(const PixelBox& box, int around, int level, int width, int height) {
  const auto up = [&](int at) { return (at + (1 << level) - 1) >> level; };
  return {std::max(0, box.x - around) >> level, std::max(0, box.y - around) >> level,
          std::min(width, up(box.x + box.width + around)), std::min(height, up(box.y + box.height + around))};
}

template <class See>
void each_block(const LevelBox& box, int side, int across, const See& see) {
  if (box.right <= box.left) return;
  for (int y = box.top / side; y * side < box.bottom; ++y)
    for (int x = box.left / side; x * side < box.right; ++x)
      see(static_cast<std::size_t>(y) * static_cast<std::size_t>(across) + static_cast<std::size_t>(x));
}

}  // namespace

BlockUses block_uses(const PackDecision& decision, const TexelsShown& shown, int page, Texture texture,
                     int level, int side) {
  const PlannedPage& of = decision.plan.pages[static_cast<std::size_t>(page)];
  const int width = std::max(1, of.width >> level), height = std::max(1, of.height >> level);
  BlockUses out;
  out.across = (width + side - 1) / side;
  out.down = (height + side - 1) / side;
  out.owner.resize(static_cast<std::size_t>(out.across) * static_cast<std::size_t>(out.down));
  out.used.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  // By block: no region, or one by its number from 1 on. The pieces of an outline are one region.
  std::vector<std::uint32_t> holds(out.owner.size());
  std::vector<std::uint8_t> shared(out.owner.size());
  const bool apart = level < decision.plan.clean_levels(page);  // mips are still those of each region
  std::uint32_t number = 0;
  for (std::size_t r = 0; r < decision.regions.size(); ++r) {
    const Region& region = decision.regions[r];
    const PlannedPlace& at = decision.plan.places[r];
    const bool piece = r > 0 && region.outline != 0 && region.outline == decision.regions[r - 1].outline &&
                       region.material == decision.regions[r - 1].material;
    if (!piece) number = static_cast<std::uint32_t>(r) + 1;
    if (at.page != page || !apart) continue;
    const PixelBox box = box_on_page(region, at);
    each_block(at_level(box, at.gutter, level, width, height), side, out.across, [&](std::size_t b) {
      if (holds[b] != 0 && holds[b] != number) shared[b] = 1;
      holds[b] = number;
    });
    if (level >= at.clean_levels || !region.in[index_of(texture)]) continue;
    const LevelBox inside = at_level(box, 0, level, width, height);
    each_block(inside, side, out.across,
               [&](std::size_t b) { out.owner[b] = static_cast<std::uint32_t>(region.material); });
    for (int y = inside.top; y < inside.bottom; ++y)
      std::fill_n(out.used.begin() + static_cast<std::ptrdiff_t>(y) * width + inside.left,
                  std::max(0, inside.right - inside.left), std::uint8_t{255});
  }
  for (std::size_t i = 0; i < shown.size(); ++i) out.used[i] = std::min(out.used[i], shown[i]);
  out.shared = static_cast<std::size_t>(std::ranges::count(shared, 1));
  return out;
}

}  // namespace etak
