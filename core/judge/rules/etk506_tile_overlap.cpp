// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"
#include "core/judge/rules/tile_boxes.h"

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
      std::vector<TileBox> by_row;
      for (const CheckTile& tile : tiles) by_row.push_back({&tile, tile.box});
      sort_by_row(by_row);
      for (std::size_t i = 0; i < by_row.size(); ++i) {
        const CheckTile* met = met_tile(by_row, i, [](const CheckTile&) { return true; });
        if (met == nullptr) continue;
        Finding& finding = check.report();
        finding.tile = by_row[i].tile->name;
        finding.box = by_row[i].box;
        finding.message = "the tile shares texels with \"" + met->name + "\"";
      }
    }};

}  // namespace etak
