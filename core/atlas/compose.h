// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/atlas/page_memory.h"
#include "core/atlas/plan.h"
#include "core/atlas/sources.h"

namespace etak {

/// The pixels of one page: both textures with their mips, in memory that the next page uses again.
class PagePixels {
 public:
  /// Prepares for a page, all zero.
  void start(const Page& page, int levels);
  /// Gives the memory back.
  void release();

  PixelsView8 view(Texture texture, int level = 0) const;
  int levels() const { return levels_; }

 private:
  struct Plane {
    PageMemory memory;
    bool used = false;  // holds texels of an earlier page
  };
  Page page_;
  int levels_ = 1;
  std::array<std::vector<Plane>, 2> planes_;
};

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
  Composer(const std::vector<PackInput>& materials, const std::vector<Region>& regions, const Plan& plan,
           const ComposeOptions& options)
      : materials_(materials), regions_(regions), plan_(plan), options_(options) {}

  /// Level 0 of every region of a page. `learned` gets an entry per material that was streamed.
  void texels(int page, PagePixels& pixels, std::vector<Learned>& learned,
              const std::function<void()>& region_done = {});

  /// Gutters of level 0, and the mips.
  void mips(int page, PagePixels& pixels);

 private:
  struct Task {
    std::size_t region;
    Texture texture;
  };
  void stream(const Task& task, const PixelsView8& page, Learned& learned, std::array<FileBytes, 2>& files);
  void place(const Task& task, const PixelsView8& page, const Image8& picture, Learned& learned);
  void region_mips(std::size_t region, PagePixels& pixels);
  void page_mips(PagePixels& pixels, int first) const;
  const MaterialPair& pair_of(std::size_t material);

  const std::vector<PackInput>& materials_;
  const std::vector<Region>& regions_;
  const Plan& plan_;
  const ComposeOptions options_;
  std::mutex pairs_lock_;
  struct Cached {
    std::once_flag once;
    MaterialPair pair;
  };
  std::map<std::size_t, Cached> pairs_;
};

/// The column or row of a picture of `size` that a sampler reads at `at`.
inline int wrapped_texel(int at, int size, Wrap wrap) {
  if (at >= 0 && at < size) return at;
  if (wrap == Wrap::clamp) return at < 0 ? 0 : size - 1;
  const int period = wrap == Wrap::mirrored ? 2 * size : size;
  const int in = (at % period + period) % period;
  return in < size ? in : period - 1 - in;
}

/// The part of a material's normal map that belongs to a box of its pictures, RGB.
Image8 normals_of(const PackInput& material, const PixelBox& box);

/// Copies `box` of a picture to column x, row y of a page; rotated: column c becomes row c, rows run from
/// right to left.
void copy_texels(const ConstPixelsView8& picture, const PixelBox& box, const PixelsView8& page, int x, int y,
                 bool rotated);

/// The material's whole pair in memory, from planes or function; what was clamped is added to `remarks`.
MaterialPair load_pair(const PackInput& material, std::vector<std::string>& remarks);

}  // namespace etak
