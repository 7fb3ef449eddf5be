// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/atlas/page_pixels.h"
#include "core/atlas/plan.h"
#include "core/atlas/sources/sources.h"

namespace etak {

/// What is learned about materials while their texels are placed.
struct Learned {
  ChannelRange range;
  std::array<std::array<std::uint64_t, 2>, 2> hash{};  // by Texture
  std::array<bool, 2> seen{};                          // by Texture
  std::array<std::size_t, 2> clamped{};  // texels whose gloss (or colour) had to be brought back to 0..1
};

struct ComposeOptions {
  unsigned threads = 1;
  GlossForm gloss = GlossForm::schueler;  // of texture B
  bool bleed = false;                     // colour of texels of alpha 0 from visible neighbours
};

/// Places regions on one page after the other.
class Composer {
 public:
  Composer(const std::vector<PackInput>& materials, const std::vector<Region>& regions,
           const PackingPlan& plan, const ComposeOptions& options);
  ~Composer();

  /// Level 0 of every region of a page. `learned` gets an entry per material that was streamed.
  void texels(int page, PagePixels& pixels, std::vector<Learned>& learned,
              const std::function<void()>& region_done = {});

  /// Gutters of level 0, and the mips.
  void mips(int page, PagePixels& pixels);

  // The same by parts, for slabs: begin_page(), any number of regions at once, end_page().

  void begin_page(int page);
  /// Those of a slab's rows that are the region's; a region that lies in several slabs is continued, one
  /// thread at a time.
  ///   worker   below options.threads: no other thread uses the same at that time
  void region_texels(std::size_t region, Texture texture, PagePixels& pixels, unsigned worker);
  /// Of a region whose texels are all there.
  void region_mips(std::size_t region, PagePixels& pixels);
  /// The levels that all regions share, which pixels holds whole.
  void end_page(int page, PagePixels& pixels, std::vector<Learned>& learned);

  /// The region's texels are as its files hold them, row by row.
  bool in_file_order(std::size_t region) const;

 private:
  struct Task {
    std::size_t region;
    Texture texture;
  };
  struct Streamed;  // a region whose files are open
  void stream(const Task& task, PagePixels& pixels, unsigned worker);
  void place(const Task& task, PagePixels& pixels, const Image8& picture, Learned& learned);
  bool mips_in_place(std::size_t region, const PlannedPlace& at, int levels, PagePixels& pixels) const;
  void mips_by_copy(std::size_t region, const PlannedPlace& at, int levels, PagePixels& pixels);
  void fill_first_gutter(std::size_t region, const PlannedPlace& at, PagePixels& pixels) const;
  void shared_mips(int page, PagePixels& pixels) const;
  void learn(std::vector<Learned>& learned) const;
  /// Where a region lies in the slab that `pixels` holds.
  PlannedPlace place_in(const PagePixels& pixels, std::size_t region) const;
  const MaterialPair& pair_of(std::size_t material);

  const std::vector<PackInput>& materials_;
  const std::vector<Region>& regions_;
  const PackingPlan& plan_;
  const ComposeOptions options_;
  std::mutex pairs_lock_;
  struct Cached {
    std::once_flag once;
    MaterialPair pair;
  };
  std::map<std::size_t, Cached> pairs_;
  // The two textures of a material are read by different threads; each has its own half of what is learned.
  std::vector<std::array<Learned, 2>> halves_;
  std::vector<std::array<FileBytes, 2>> files_;  // by worker
  std::vector<std::array<std::unique_ptr<Streamed>, 2>> open_;
  int clean_ = 1;
};

}  // namespace etak
