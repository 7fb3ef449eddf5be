// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/atlas/planning.h"
#include "core/base/error.h"
#include "core/base/setting.h"

namespace etak {
namespace planning {
namespace {

// The side that no region of a page may exceed.
int largest_cell(const RectOptions& options) {
  if (options.form == PageForm::pages) return options.side;
  if (options.form != PageForm::mixed) return options.largest_side;
  int out = 1;
  while (out <= options.side / 2) out *= 2;
  return out;
}

std::string text_of(const RectSize& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

// The region's material, and its texels with their gutter.
std::string place_of(const Planning& in, const Cells& cells, std::size_t region) {
  const Region& of = in.regions[region];
  std::string out = in.names[of.material] + ": " + text_of({of.width(), of.height()}) + " texels";
  if (cells.gutters[region] > 0)
    out += ", " + text_of(cells.sizes[region]) + " with a gutter of " + std::to_string(cells.gutters[region]);
  return out;
}

}  // namespace

Cells cells_of(const std::vector<Region>& regions, const PlanOptions& options, bool gutters,
               int clean_limit) {
  Cells out;
  for (const Region& region : regions) {
    const int smaller = std::min(region.width(), region.height());
    const int wanted = levels_wanted(options.levels, region.levels);
    const int most = clean_limit > 0 ? std::min(clean_limit, wanted) : wanted;
    int clean = clean_levels(region.width(), region.height(), most, options.gutter);
    // A grid of blocks is coarser: one clean mip less leaves as few texels between regions as without blocks.
    if (options.block_side > 0 && !options.gutter) clean = std::max(1, clean - 1);
    // Bilinear filtering of the last clean mip, 2^(clean - 1) texels to one, reads one beyond the edge.
    const int needed = gutters ? std::max(options.least_gutter, 1 << (clean - 1)) : 0;
    // A given gutter grows to the grid of the mips: the region itself must begin on it.
    const int gutter = options.gutter ? rounded_up(*options.gutter, 1 << (clean - 1)) : needed;
    if (!gutters && !options.gutter)
      clean = std::min(most, std::max(1, log2_floor(smaller / (2 * std::max(1, options.block_side)))));
    out.gutters.push_back(gutter);
    out.clean.push_back(clean);
    if (options.block_side > 0)
      out.align = std::max(out.align, options.block_side << (clean - 1));
    else if (wanted > 1)
      out.align = std::max(out.align, 1 << (clean - 1));
  }
  // One grid for all cells, so that every texel of every clean mip belongs to one region. A grid coarser than
  // a quarter of the usual region would waste more than the last mips are worth.
  for (std::size_t i = 0; i < regions.size(); ++i) {
    out.sizes.push_back({rounded_up(regions[i].width() + 2 * out.gutters[i], out.align),
                         rounded_up(regions[i].height() + 2 * out.gutters[i], out.align)});
  }
  return out;
}

bool fits(const Planning& in, const Cells& cells) {
  for (std::size_t i = 0; i < in.regions.size(); ++i)
    if (!in.regions[i].own_page &&
        std::max(cells.sizes[i].width, cells.sizes[i].height) > in.options.rects.largest_side)
      return false;
  return true;
}

void check_sizes(const Planning& in, const Cells& cells, const RectOptions& options) {
  const int most = largest_cell(options);
  for (std::size_t i = 0; i < in.regions.size(); ++i) {
    const Region& region = in.regions[i];
    const int side = std::max(cells.sizes[i].width, cells.sizes[i].height);
    if (region.own_page || side <= most) continue;
    std::string help = setting("page") + " " + std::to_string(side);
    if (side <= options.largest_side)
      help = setting("page-form") + " free";
    else if (std::max(region.width(), region.height()) <= most)
      help += " or " + setting("gutter") + " 0";
    throw Error(place_of(in, cells, i) + "; expected at most " + std::to_string(most) + " a side (" + help +
                " would do)");
  }
}

void refuse_too_many(const Planning& in, const Cells& cells, const std::vector<std::size_t>& which,
                     const RectOptions& options) {
  const auto area = [&](std::size_t i) {
    return static_cast<std::uint64_t>(cells.sizes[i].width) *
           static_cast<std::uint64_t>(cells.sizes[i].height);
  };
  std::uint64_t all = 0;
  std::size_t largest = which.front();
  for (const std::size_t i : which) {
    all += area(i);
    if (area(i) > area(largest)) largest = i;
  }
  const std::string side = std::to_string(options.largest_side);
  throw Error(std::to_string(which.size()) + " regions, the largest of " + place_of(in, cells, largest) +
              ", of together " + std::to_string(all) + " texels do not fit one page; expected at most " +
              side + " x " + side + " (" + setting("page-form") + " mixed or a larger " + setting("page") +
              " would do)");
}

}  // namespace planning

int default_clean_levels(int width, int height) {
  return 1 + planning::log2_floor(std::max(1, std::min(width, height) / 32));
}

int levels_wanted(int asked, int read) {
  constexpr int all = 16;
  return std::min(asked == 0 ? all : asked, read == 0 ? all : read);
}

int clean_levels(int width, int height, int wanted, std::optional<int> gutter) {
  const bool given = gutter && *gutter > 0;
  return std::min(wanted, given ? 1 + planning::log2_floor(*gutter) : default_clean_levels(width, height));
}

}  // namespace etak
