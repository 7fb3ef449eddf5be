// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <optional>

#include "core/rects/index.h"
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

/// A layout. Spots are by canonical index. Page sides are the extents of what lies there; those of square
/// pages and of powers of two have their final lengths.
struct Packed {
  std::vector<RectSize> pages;
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

/// The greatest power of two that is not above `value`; value: at least 1.
constexpr int power_below(int value) {
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(value)));
}

/// Drops the pages on which nothing lies.
///   page_of   the page of a place, by reference
template <class Place, class PageOf>
void drop_empty(std::vector<RectSize>& pages, std::vector<Place>& places, PageOf page_of) {
  std::vector<int> number(pages.size(), -1);
  for (Place& place : places) number[at(page_of(place))] = 0;
  std::vector<RectSize> kept;
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (number[p] < 0) continue;
    number[p] = static_cast<int>(kept.size());
    kept.push_back(pages[p]);
  }
  for (Place& place : places) page_of(place) = number[at(page_of(place))];
  pages.swap(kept);
}

}  // namespace etak::rects
