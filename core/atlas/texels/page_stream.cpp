// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/texels/page_stream.h"

#include <algorithm>

#include "core/base/files/output_folder.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"

namespace etak {
namespace {

// Bytes of one texture. Threads wait for each other at the end of every slab, so slabs should not be smaller;
// larger slabs do not fit the processor's cache.
constexpr std::size_t least_slab = std::size_t{4} << 20, large_slab = std::size_t{24} << 20;
// Levels that are held for a slab only; the next level takes a sixteenth of level 0 for the whole page.
constexpr int most_cut_levels = 2;

std::size_t row_bytes(const PlannedPage& page) {
  return 4 * static_cast<std::size_t>(page.width);
}

// Cuts at multiples of `step` that go through no cell.
std::vector<int> cuts_between_cells(const PackingPlan& plan, int page, int step) {
  const PlannedPage& size = plan.pages[static_cast<std::size_t>(page)];
  std::vector<bool> inside(static_cast<std::size_t>(size.height) + 1, false);
  for (const PlannedPlace& place : plan.places) {
    if (place.page != page) continue;
    const auto first = inside.begin() + place.cell.y + 1;
    std::fill(first, first + std::max(0, place.cell.height - 1), true);
  }
  std::vector<int> out{0};
  for (int y = step; y + step <= size.height; y += step) {
    const auto bytes = row_bytes(size) * static_cast<std::size_t>(y - out.back());
    if (!inside[static_cast<std::size_t>(y)] && bytes >= least_slab) out.push_back(y);
  }
  out.push_back(size.height);
  return out;
}

// Cuts of even distance, which may go through cells.
std::vector<int> cuts_anywhere(const PlannedPage& page) {
  const int rows = static_cast<int>((least_slab + row_bytes(page) - 1) / row_bytes(page));
  std::vector<int> out;
  for (int y = 0; y < page.height; y += rows) out.push_back(y);
  out.push_back(page.height);
  return out;
}

bool none_cut_through(const PackingPlan& plan, int page, const std::vector<int>& cuts) {
  return std::none_of(plan.places.begin(), plan.places.end(), [&](const PlannedPlace& place) {
    const auto next = std::upper_bound(cuts.begin(), cuts.end(), place.cell.y);
    return place.page == page && next != cuts.end() && *next < place.cell.y + place.cell.height;
  });
}

std::size_t largest_slab(const std::vector<int>& cuts, const PlannedPage& page) {
  int rows = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) rows = std::max(rows, cuts[i] - cuts[i - 1]);
  return row_bytes(page) * static_cast<std::size_t>(rows);
}

// Writes one level of one texture to a file, slab after slab.
class LevelFile {
 public:
  ///   width   of the level, in texels
  LevelFile(const StreamedPage& of, Texture texture, int level, int width,
            const std::shared_ptr<PngBands::Scratch>& scratch)
      : texture_(texture), level_(level), file_(of.folder->open(page_file(of.page, texture, "png", level))) {
    PngOptions options;
    options.level = *of.write.png_level;
    bands_ = std::make_unique<PngBands>(
        PictureHeader{width, std::max(1, of.size().height >> level), 4, 8}, options,
        [this](std::string_view bytes) { file_->add(bytes); }, scratch);
  }

  std::size_t next(const PagePixels& pixels) {
    const PixelsView8 rows = pixels.view(texture_, level_);
    return bands_->next(rows.data, rows.stride, rows.height);
  }
  void make(std::size_t strip) { bands_->make(strip); }
  void close() {
    bands_->finish();
    file_->close();
  }

 private:
  Texture texture_;
  int level_;
  std::unique_ptr<OutputFolder::File> file_;
  std::unique_ptr<PngBands> bands_;
};

struct Strip {
  LevelFile* file;
  std::size_t index;
};

// The files of a page that are written at the same time.
class LevelFiles {
 public:
  explicit LevelFiles(const StreamedPage& of) : of_(of) {}

  // Opens the files of the levels [begin, end), whose widths are those of `pixels`.
  void open(int begin, int end, const PagePixels& pixels) {
    for (int l = begin; l < end && of_.folder != nullptr; ++l)
      for (const Texture texture : both_textures)
        if (of_.size().has[index_of(texture)])
          files_.push_back(
              std::make_unique<LevelFile>(of_, texture, l, pixels.view(texture, l).width, scratch_));
  }
  // The pieces of work that compress the rows in `from`.
  std::vector<Strip> strips(const PagePixels& from) const {
    std::vector<Strip> out;
    for (const auto& file : files_)
      for (std::size_t count = file->next(from), i = 0; i < count; ++i) out.push_back({file.get(), i});
    return out;
  }
  void close() {
    for (const auto& file : files_) file->close();
    files_.clear();
  }

 private:
  const StreamedPage& of_;
  const std::shared_ptr<PngBands::Scratch> scratch_ = PngBands::scratch();
  std::vector<std::unique_ptr<LevelFile>> files_;
};

// The regions that have texels between two rows of the page, and whether they cover all texels there.
struct SlabRegions {
  std::vector<std::size_t> regions;
  bool covered = false;
};
SlabRegions regions_between(const StreamedPage& of, int top, int bottom, int cut_levels) {
  SlabRegions out;
  std::int64_t covered = 0;
  bool aligned = true;
  const int grid = 1 << std::max(0, cut_levels - 1);
  for (std::size_t r = 0; r < of.regions.size(); ++r) {
    const PixelBox& cell = of.plan.places[r].cell;
    const int first = std::max(cell.y, top), last = std::min(cell.y + cell.height, bottom);
    if (of.plan.places[r].page != of.page || first >= last) continue;
    out.regions.push_back(r);
    covered += std::int64_t{cell.width} * (last - first);
    aligned = aligned && (cell.x | cell.y | cell.width | cell.height) % grid == 0;
  }
  out.covered = aligned && covered == std::int64_t{of.size().width} * (bottom - top);
  return out;
}

void start_slab(const StreamedPage& of, const Slab& slab, PagePixels& pixels, PagePixels& upper) {
  with_memory_for(
      page_file(of.page, Texture::diffuse_alpha, "png"),
      [&] {
        return "a page of " + std::to_string(of.size().width) + " x " + std::to_string(of.size().height) +
               " texels and its mips, of which " + std::to_string(slab.bottom - slab.top) +
               " rows are held at once";
      },
      [&] { pixels.start(of.size(), of.levels, slab, upper); });
}

}  // namespace

std::vector<int> page_cuts(const Composer& composer, const std::vector<Region>& regions,
                           const PackingPlan& plan, int page, int levels, bool bleed) {
  const PlannedPage& size = plan.pages[static_cast<std::size_t>(page)];
  const int clean = plan.clean_levels(page);
  // The page's own mips are made from the last clean level, which must be one that is held whole.
  if (levels > clean && clean == 1) return {0, size.height};
  const std::vector<int> between = cuts_between_cells(plan, page, 1 << (std::min(levels, clean) - 1));
  bool anywhere = levels == 1 && !bleed;
  for (std::size_t r = 0; r < regions.size() && anywhere; ++r) {
    const PlannedPlace& place = plan.places[r];
    if (place.page != page) continue;
    const PixelBox whole{place.x, place.y, regions[r].box.width, regions[r].box.height};
    anywhere = composer.in_file_order(r) && place.cell == whole;
  }
  return anywhere && largest_slab(between, size) > large_slab ? cuts_anywhere(size) : between;
}

void stream_page(Composer& composer, const StreamedPage& of, std::vector<Learned>& learned) {
  const std::vector<int>& cuts = of.cuts;
  const int clean = of.plan.clean_levels(of.page);
  const int cut_levels = std::min({of.levels, most_cut_levels, of.levels > clean ? clean - 1 : of.levels});
  // Two slabs: one is made, one is written. The first holds the levels that are not cut.
  std::array<PagePixels, 2> pixels;
  LevelFiles files(of);
  const bool whole_regions = none_cut_through(of.plan, of.page, cuts);
  const std::size_t per_region = whole_regions ? 1 : 2;
  composer.begin_page(of.page);
  std::vector<Strip> strips;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    PagePixels& now = pixels[k % 2];
    const bool makes = k + 1 < cuts.size();
    SlabRegions here;
    if (makes) {
      here = regions_between(of, cuts[k], cuts[k + 1], cut_levels);
      start_slab(of, {cuts[k], cuts[k + 1], cut_levels, here.covered}, now, pixels[0]);
      if (k == 0) files.open(0, cut_levels, pixels[0]);
    }
    // The regions of this slab first, then the strips of the one above it: the smaller pieces of work come
    // last, so that no thread waits long.
    const std::size_t parts = here.regions.size() * per_region;
    parallel_chunks(parts + strips.size(), of.write.threads, 1,
                    [&](std::size_t i, std::size_t, unsigned worker) {
                      if (i >= parts) return strips[i - parts].file->make(strips[i - parts].index);
                      const std::size_t region = here.regions[i / per_region];
                      for (const Texture texture : both_textures) {
                        const std::size_t t = index_of(texture);
                        if (!of.size().has[t] || (!whole_regions && i % 2 != t)) continue;
                        composer.region_texels(region, texture, now, worker);
                        const PixelBox& cell = of.plan.places[region].cell;
                        if (of.region_done && cell.y + cell.height <= cuts[k + 1]) of.region_done();
                      }
                      if (whole_regions) composer.region_mips(region, now);
                    });
    if (makes) strips = files.strips(now);
  }
  files.close();
  composer.end_page(of.page, pixels[0], learned);
  files.open(cut_levels, of.levels, pixels[0]);
  strips = files.strips(pixels[0]);
  parallel_chunks(strips.size(), of.write.threads, 1,
                  [&](std::size_t i, std::size_t, unsigned) { strips[i].file->make(strips[i].index); });
  files.close();
}

}  // namespace etak
