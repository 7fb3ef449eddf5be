// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace etak {

// Packing of rectangles. Nothing here knows of pictures.

/// Width and height of a rectangle or a page, in texels.
struct RectSize {
  int width = 0, height = 0;
  friend bool operator==(const RectSize&, const RectSize&) = default;
};

/// Where a rectangle lies. Rotated ones take height x width texels of their page.
struct RectPlace {
  int page = 0, x = 0, y = 0;
  bool rotated = false;
  friend bool operator==(const RectPlace&, const RectPlace&) = default;
};

/// What pages may look like.
///   square         one page, least integer side
///   power_of_two   one page, both sides powers of two, least area
///   free           one page, any sides
///   strip          one page of width `side`, least height
///   pages          as few pages of side x side as possible
///   mixed          any number of pages with sides that are powers of two up to `side`, least total area
enum class PageForm { square, power_of_two, free, strip, pages, mixed };

/// The form of the pages, and how long to search.
struct RectOptions {
  PageForm form = PageForm::free;
  int side = 0;              // of strip, pages, mixed
  int largest_side = 16384;  // no page is larger
  int multiple = 1;          // every page side is a multiple of it (4 for block compression); not for strip
  int align = 1;             // every rectangle's corner lies on a multiple of it; `side` has to be one
  bool rotate = false;
  // The most tries, of which each is an order of the rectangles under a placement rule. All tries together
  // take no more operations than that many of ordinary cost. power_of_two has so many for each page size,
  // free a part of them for each width. The same number gives the same layout on every machine. With
  // `rotate` the tries without rotation come first.
  int effort = 100;
  double max_seconds = 0;  // above 0: no try begins later than this; the layout then depends on the machine
  unsigned threads = 1;    // never changes the layout
};

/// The pages, and the place of each rectangle on them.
struct RectLayout {
  std::vector<RectSize> pages;
  std::vector<RectPlace> places;  // in the order of the input
  std::string method;             // the rule and order of the best layout, for reports
  int tries = 0;
  bool cut_by_time = false;
  bool kept_previous = false;  // unchanged rectangles stayed where they were
  std::size_t moved = 0;       // rectangles of the previous layout that lie elsewhere now

  std::size_t page_texels() const;
};

/// Where rectangles were in an earlier layout, for stability; `places[i]` belongs to rectangle i of the new
/// input, none for a new or resized one.
struct PreviousRects {
  std::vector<RectSize> pages;
  std::vector<std::optional<RectPlace>> places;
  double most_extra_area = 0.05;  // staying may cost this share of the fresh layout's page area
};

/// Packs rectangles without overlap and inside the pages. The layout depends on the multiset of sizes and the
/// options alone (equal sizes are placed in the order of their indices), not on the order of the input or on
/// threads. With `rotate` the layout is never larger than without; with `previous` it is never larger than
/// the previous layout where that still holds all rectangles. Throws Error for sides outside
/// 1..largest_side, a rectangle larger than a page, or options out of range.
RectLayout pack_rects(std::span<const RectSize> sizes, const RectOptions& options,
                      const PreviousRects* previous = nullptr);

/// What is wrong with a layout (overlap, outside of its page, wrong count), or nothing. Does not depend on
/// how the layout was made.
std::optional<std::string> layout_fault(std::span<const RectSize> sizes, const RectLayout& layout);

}  // namespace etak
