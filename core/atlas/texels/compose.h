// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/atlas/plan.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_pixels.h"
#include "core/base/once.h"

namespace etak {

/// What the texels of a material tell while they are placed.
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

  /// Level 0 of every region of a page.
  ///   learned       by material; filled in where the material's texels were read
  ///   region_done   called after each texture of each region, from any thread
  void texels(int page, PagePixels& pixels, std::vector<Learned>& learned,
              const std::function<void()>& region_done = {});

  /// Gutters of level 0, and the mips.
  void mips(int page, PagePixels& pixels);

  // texels() and mips() in parts, for pages in slabs: begin_page(), then regions on any threads, then
  // end_page().

  void begin_page(int page);
  /// The rows of level 0 that the region has in a slab. A region in several slabs goes on where it ended in
  /// the slab above; only one thread at a time may work on it.
  ///   worker   number of the thread, below options.threads: no two threads use the same number at a time
  void region_texels(std::size_t region, Texture texture, PagePixels& pixels, unsigned worker);
  /// The mips of a region whose level 0 is complete, and the gutters of all its levels; of the first piece of an outline those
  /// of the whole outline.
  void region_mips(std::size_t region, PagePixels& pixels);
  /// The levels that mix the texels of neighbouring regions. `pixels` holds these levels for the whole page.
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
  /// The material's normal map at the size of its pictures; null where so many levels need none.
  const Image8* normals_for(std::size_t material, int levels);
  /// The region after the pieces of this one's outline, or after this one.
  std::size_t end_of_outline(std::size_t region) const;

  const std::vector<PackInput>& materials_;
  const std::vector<Region>& regions_;
  const PackingPlan& plan_;
  const ComposeOptions options_;
  std::mutex pairs_lock_;
  struct Cached {
    Once once, normals_once;
    MaterialPair pair;
    Image8 normals;
  };
  std::map<std::size_t, Cached> pairs_;
  // Different threads read the two textures of a material; what they learn is kept apart, by Texture.
  std::vector<std::array<Learned, 2>> halves_;
  std::vector<std::array<FileBytes, 2>> files_;  // by worker
  std::vector<std::array<std::unique_ptr<Streamed>, 2>> open_;
  int clean_ = 1;
};

}  // namespace etak
