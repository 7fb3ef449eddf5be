// SPDX-License-Identifier: Apache-2.0
// Density of pages of islands: by their boxes, as rectangles are packed, and by their outlines.
//   bench_islands SET...   files of tests/bench/islands
// Prints CSV: set, islands, gutter, turned or not; of boxes and of outlines each: texels of the page, the share of it that the
// islands' own texels take, the same with their gutters, and ms.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/atlas/outline_pieces.h"
#include "tests/bench/island_sets.h"

using namespace etak;

namespace {

void tell(const std::vector<Region>& regions, const PlanOptions& options, double own, double cells) {
  const auto start = std::chrono::steady_clock::now();
  const PackingPlan plan = plan_pages(regions, {"m"}, options);
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const auto page = static_cast<double>(plan.page_texels() / 2);
  std::printf(",%.0f,%.2f,%.2f,%.1f", page, 100 * own / page, 100 * cells / page, ms);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2) return std::fprintf(stderr, "usage: bench_islands SET...\n"), 2;
  std::printf(
      "set,islands,gutter,rotate,boxes,own_%%,with_gutters_%%,ms,outlines,own_%%,with_gutters_%%,ms\n");
  for (int i = 1; i < count; ++i) {
    std::ifstream file(arguments[i]);
    const std::vector<Region> islands = test::read_islands(file);
    if (islands.empty()) throw std::runtime_error(std::string(arguments[i]) + ": no islands");
    std::vector<Region> boxes = islands;
    for (Region& box : boxes) box.texels.clear();
    for (const int gutter : {0, 1, 2, 4})
      for (const bool rotate : {false, true}) {
        PlanOptions options;
        options.rects.form = PageForm::free;
        options.rects.rotate = rotate;
        options.gutter = gutter;
        options.may_inset = false;
        double own = 0, cells = 0;
        for (const Region& region : islands) {
          own += static_cast<double>(region.area());
          cells += static_cast<double>(count_of(cell_shape(region, gutter, 1, 1).runs));
        }
        std::printf("%s,%zu,%d,%d", std::filesystem::path(arguments[i]).stem().c_str(), islands.size(),
                    gutter, int{rotate});
        tell(boxes, options, own, cells);
        tell(islands, options, own, cells);
        std::printf("\n");
      }
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_islands: %s\n", error.what());
  return 2;
}
