// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/rects/search.h"

namespace etak::rects {

// Packing into each form of page, by Search. All lengths are in units (see set.h) except where texels are
// named.

/// The options in units.
struct Frame {
  PageForm form = PageForm::free;
  int unit = 1;      // texels
  int multiple = 1;  // texels; of page sides
  int side = 0;      // of strip, pages
  int side_in_texels = 0;
  int largest = 0;
  bool rotate = false;
  int effort = 0;
  unsigned threads = 1;

  /// A length in units as a page side in texels.
  int side_texels(int length) const;
};

struct PageSize {
  int width = 0, height = 0;
};

/// A layout. Spots are by canonical index. Page sides are the extents of what lies there; those of square
/// pages and of powers of two have their final lengths.
struct Packed {
  std::vector<PageSize> pages;
  std::vector<Spot> spots;
  std::vector<int> page_of;
  std::string method;
};

/// None where no page that is allowed holds the set.
std::optional<Packed> pack_square(const Set& set, const Frame& frame, Budget& budget);
std::optional<Packed> pack_strip(const Set& set, const Frame& frame, Budget& budget);
std::optional<Packed> pack_free(const Set& set, const Frame& frame, Budget& budget);
std::optional<Packed> pack_power_of_two(const Set& set, const Frame& frame, Budget& budget);

/// As few pages of width x height as possible.
Packed pack_pages(const Set& set, const Frame& frame, int width, int height, Budget& budget);
/// Pages of powers of two with the least total area.
Packed pack_mixed(const Set& set, const Frame& frame, Budget& budget);

/// The least power of two of texels that holds a length in units.
int power_of_two_texels(const Frame& frame, int length);

}  // namespace etak::rects
