// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk506_tile_overlap{
    .id = "ETK506",
    .slug = "tile-overlap",
    .title = "Tiles overlap or leave their page",
    .severity = Severity::error,
    .needs = {Need::layout},
    .source = "etak",
    .what = "Atlas: rectangles of one page share texels, or reach beyond the page.",
    .why = "One tile shows the other's texels.",
    .example = "A layout edited by hand.",
    .fix = "Pack again.",
    .check = [](RuleCheck& check) {
      const auto& tiles = check.target.manifest.tiles;
      const auto& picture = check.evidence.b ? check.evidence.b : check.evidence.a;
      if (picture)
        for (const CheckTile& tile : tiles) {
          const PixelBox& box = tile.box;
          if (box.x >= 0 && box.y >= 0 && box.width > 0 && box.height > 0 &&
              box.width <= picture->header.width - box.x && box.height <= picture->header.height - box.y)
            continue;
          Finding& finding = check.report();
          finding.tile = tile.name;
          finding.box = box;
          finding.message = "the tile leaves its page of " + std::to_string(picture->header.width) + " x " +
                            std::to_string(picture->header.height);
        }
      std::vector<const CheckTile*> by_row;
      for (const CheckTile& tile : tiles) by_row.push_back(&tile);
      std::stable_sort(by_row.begin(), by_row.end(),
                       [](const CheckTile* a, const CheckTile* b) { return a->box.y < b->box.y; });
      for (std::size_t i = 0; i < by_row.size(); ++i) {
        const PixelBox& a = by_row[i]->box;
        for (std::size_t j = i + 1; j < by_row.size() && by_row[j]->box.y < a.y + a.height; ++j) {
          const PixelBox& b = by_row[j]->box;
          if (by_row[i]->page != by_row[j]->page || b.x >= a.x + a.width || a.x >= b.x + b.width ||
              b.height <= 0 || a.height <= 0)
            continue;
          Finding& finding = check.report();
          finding.tile = by_row[i]->name;
          finding.box = a;
          finding.message = "the tile shares texels with \"" + by_row[j]->name + "\"";
          break;  // one per tile
        }
      }
    }};

}  // namespace etak
