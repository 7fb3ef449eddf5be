// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/atlas/plan.h"
#include "core/atlas/texels/page_memory.h"
#include "core/image/pixels_view.h"

namespace etak {

/// The index of a texture in arrays over both textures.
constexpr std::size_t index_of(Texture texture) {
  return static_cast<std::size_t>(texture);
}

/// Rows [top, bottom) of a page, which are made and written before those below them.
struct Slab {
  int top = 0, bottom = 0;
  int cut_levels = 0;    // the first levels, which are held for these rows only; others for the whole page
  bool covered = false;  // regions overwrite all of its texels
};

/// The pixels of one page, or of a slab of it: both textures with their mips. The next page or slab uses the
/// same memory.
class PagePixels {
 public:
  /// Prepares for a page, all zero.
  void start(const PlannedPage& page, int levels);
  /// Prepares for a slab, all zero unless it is covered. The slabs of a page come from the top.
  ///   upper   holds the levels of the whole page; it may be this
  void start(const PlannedPage& page, int levels, const Slab& slab, PagePixels& upper);
  /// From here on view() shows all of the levels that are held whole.
  void show_whole_levels();
  /// Frees the memory.
  void release();

  /// The slab's rows of a level.
  PixelsView8 view(Texture texture, int level = 0) const;
  int levels() const { return levels_; }
  int top() const { return slab_.top; }

 private:
  struct Plane {
    PageMemory memory;
    bool used = false;  // holds texels of an earlier page
  };
  void prepare(Plane& plane, std::size_t bytes, bool covered);
  int first_row(int level) const { return slab_.top >> level; }
  int rows(int level) const;

  PlannedPage page_;
  Slab slab_;
  const PagePixels* upper_ = nullptr;
  int levels_ = 1;
  std::array<std::vector<Plane>, 2> planes_;
};

}  // namespace etak
