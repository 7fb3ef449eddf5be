// SPDX-License-Identifier: Apache-2.0
#include "core/rects/rects.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/base/error.h"
#include "core/rects/index.h"
#include "core/rects/pack.h"
#include "core/rects/previous.h"

namespace etak {
namespace {

using namespace rects;

std::string text(const RectSize& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void check(const RectOptions& options) {
  const auto refuse = [](const char* what, long long found, const std::string& expected) {
    throw Error::at(what, std::to_string(found), expected);
  };
  constexpr int most = 1 << 24;
  if (options.largest_side < 1 || options.largest_side > most)
    refuse("largest side", options.largest_side, "1 to " + std::to_string(most));
  const bool with_side =
      options.form == PageForm::strip || options.form == PageForm::pages || options.form == PageForm::mixed;
  if (with_side && (options.side < 1 || options.side > options.largest_side))
    refuse("page side", options.side, "1 to " + std::to_string(options.largest_side));
  if (options.align < 1 || options.align > options.largest_side)
    refuse("alignment", options.align, "1 to " + std::to_string(options.largest_side));
  if (options.multiple < 1 || options.multiple > options.largest_side)
    refuse("multiple", options.multiple, "1 to " + std::to_string(options.largest_side));
  const bool powers = options.form == PageForm::power_of_two || options.form == PageForm::mixed;
  if (powers && (options.multiple & (options.multiple - 1)) != 0)
    refuse("multiple", options.multiple, "a power of two, as the page sides are");
  if (options.form == PageForm::pages && options.side % options.multiple != 0)
    refuse("page side", options.side, "a multiple of " + std::to_string(options.multiple));
  if (with_side && options.side % options.align != 0)
    refuse("page side", options.side, "a multiple of the alignment, " + std::to_string(options.align));
  if (options.effort < 1 || options.effort > 1'000'000) refuse("effort", options.effort, "1 to 1000000");
  if (!(options.max_seconds >= 0))
    throw Error::at("seconds", "is negative or no number", "0 (no limit) or more");
}

void check(std::span<const RectSize> sizes, const RectOptions& options) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const RectSize& size = sizes[i];
    const auto refuse = [&](const std::string& expected) {
      throw Error::at("rectangle " + std::to_string(i + 1), text(size), expected);
    };
    const int largest = options.largest_side;
    if (size.width < 1 || size.height < 1 || size.width > largest || size.height > largest)
      refuse("sides of 1 to " + std::to_string(largest));
    const int w = options.rotate ? std::min(size.width, size.height) : size.width;
    if (options.form == PageForm::strip && w > options.side)
      refuse("at most as wide as the strip, " + std::to_string(options.side));
    if (options.form == PageForm::pages && std::max(size.width, size.height) > options.side)
      refuse("at most as large as a page, " + std::to_string(options.side) + " x " +
             std::to_string(options.side));
    const int power = power_below(std::max(1, options.side));  // no page has a longer side
    if (options.form == PageForm::mixed && std::max(size.width, size.height) > power)
      refuse("at most as large as a page, " + std::to_string(power) + " x " + std::to_string(power));
  }
}

// The input in canonical order and in units.
struct Prepared {
  std::vector<int> order;  // of the input, by canonical index
  Set set;
  Frame frame;
};

Prepared prepare(std::span<const RectSize> sizes, const RectOptions& options) {
  Prepared out;
  out.order.resize(sizes.size());
  std::iota(out.order.begin(), out.order.end(), 0);
  const auto rank = [&](int i) {
    const RectSize& size = sizes[at(i)];
    return std::make_tuple(-std::max(size.width, size.height), -std::min(size.width, size.height),
                           -size.width, i);
  };
  std::sort(out.order.begin(), out.order.end(), [&](int a, int b) { return rank(a) < rank(b); });

  // Everything is a multiple of the largest common divisor of the sides: no packing is lost by counting in
  // it.
  const int align = options.align;
  const auto whole = [&](int side) { return (side + align - 1) / align * align; };
  int unit = 0;
  for (const RectSize& size : sizes) unit = std::gcd(unit, std::gcd(whole(size.width), whole(size.height)));
  if (unit == 0) unit = align;
  std::vector<RectSize> canonical;
  for (const int i : out.order)
    canonical.push_back({whole(sizes[at(i)].width) / unit, whole(sizes[at(i)].height) / unit});
  out.set = Set(std::move(canonical));
  out.frame = {
      options.form,        unit,           options.form == PageForm::strip ? 1 : options.multiple,
      options.side / unit, options.side,   options.largest_side / options.multiple * options.multiple / unit,
      options.rotate,      options.effort, options.threads};
  return out;
}

// Back to texels and the order of the input. Of equal sizes the earlier in the input lies earlier (page, then
// from below, then from the left).
RectLayout finish(std::span<const RectSize> sizes, const Prepared& prepared, const Packed& packed) {
  RectLayout out;
  out.method = packed.method;
  out.places.resize(sizes.size());
  const int unit = prepared.frame.unit;
  const std::vector<int>& order = prepared.order;
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    std::vector<RectPlace> places;
    const RectSize size = sizes[at(order[first])];
    for (; end < order.size() && sizes[at(order[end])] == size; ++end) {
      const Spot& spot = packed.spots[end];
      places.push_back(
          {packed.page_of[end], spot.x * unit, spot.y * unit, spot.rotated && size.width != size.height});
    }
    std::sort(places.begin(), places.end(), [](const RectPlace& a, const RectPlace& b) {
      return std::tie(a.page, a.y, a.x) < std::tie(b.page, b.y, b.x);
    });
    for (std::size_t k = first; k < end; ++k) out.places[at(order[k])] = places[k - first];
    first = end;
  }
  out.pages.resize(packed.pages.size());
  return out;
}

}  // namespace

namespace rects {

void fit_pages(std::span<const RectSize> sizes, const RectOptions& options, RectLayout& layout) {
  for (RectSize& page : layout.pages) page = {};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const RectPlace& place = layout.places[i];
    RectSize& page = layout.pages[at(place.page)];
    page.width = std::max(page.width, place.x + (place.rotated ? sizes[i].height : sizes[i].width));
    page.height = std::max(page.height, place.y + (place.rotated ? sizes[i].width : sizes[i].height));
  }
  const auto up = [&](int side) {
    return (side + options.multiple - 1) / options.multiple * options.multiple;
  };
  const auto power = [&](int side) {
    int out = options.multiple;
    while (out < side) out *= 2;
    return out;
  };
  for (RectSize& page : layout.pages) switch (options.form) {
      case PageForm::square:
        page.width = page.height = up(std::max(page.width, page.height));
        break;
      case PageForm::power_of_two:
      case PageForm::mixed:
        page = {power(page.width), power(page.height)};
        break;
      case PageForm::free:
        page = {up(page.width), up(page.height)};
        break;
      case PageForm::strip:
        page.width = options.side;
        break;
      case PageForm::pages:
        page.width = page.height = options.side;
        break;
    }
}

RectLayout pack_fresh(std::span<const RectSize> sizes, const RectOptions& options) {
  if (sizes.empty()) return {};
  const Prepared prepared = prepare(sizes, options);
  const Set& set = prepared.set;
  Frame frame = prepared.frame;
  // A square is one search, where a free page has one for each width: ten times the tries still take less.
  constexpr int square_tries = 10, most_tries = 1'000'000;
  if (frame.form == PageForm::square) frame.effort = std::min(most_tries, square_tries * frame.effort);
  Budget budget(options.effort, set.size(), options.max_seconds);
  std::optional<Packed> packed;
  switch (options.form) {
    case PageForm::square:
      packed = pack_square(set, frame, budget);
      break;
    case PageForm::power_of_two:
      packed = pack_power_of_two(set, frame, budget);
      break;
    case PageForm::free:
      packed = pack_free(set, frame, budget);
      break;
    case PageForm::strip:
      packed = pack_strip(set, frame, budget);
      break;
    case PageForm::pages:
      packed = pack_pages(set, frame, frame.side, frame.side, budget);
      break;
    case PageForm::mixed:
      packed = pack_mixed(set, frame, budget);
      break;
  }
  if (!packed || packed->pages.empty())
    throw Error::at("rectangles",
                    "do not fit one page of at most " + std::to_string(options.largest_side) + " x " +
                        std::to_string(options.largest_side),
                    "fewer or smaller ones, or several pages");
  RectLayout out = finish(sizes, prepared, *packed);
  fit_pages(sizes, options, out);
  out.tries = budget.tries();
  out.cut_by_time = budget.cut();
  return out;
}

}  // namespace rects

RectLayout pack_rects(std::span<const RectSize> sizes, const RectOptions& options,
                      const PreviousRects* previous) {
  check(options);
  check(sizes, options);
  RectLayout fresh = pack_fresh(sizes, options);
  return previous ? keep_previous(sizes, options, *previous, std::move(fresh)) : fresh;
}

}  // namespace etak
