// SPDX-License-Identifier: Apache-2.0
#include "core/rects/masks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string_view>

#include "core/base/parallel.h"
#include "core/math/functions.h"
#include "core/rects/index.h"
#include "core/rects/mask_page.h"

namespace etak {
namespace {

using rects::at, rects::MaskPage, rects::put_lowest;
using Ready = rects::ReadyMask;

struct Order {
  std::string_view name;
  double (*key)(const Ready&);  // the largest first
};
constexpr std::array<Order, 4> orders{{
    {"height", [](const Ready& r) { return static_cast<double>(r.shape.height); }},
    {"perimeter", [](const Ready& r) { return static_cast<double>(r.shape.width + r.shape.height); }},
    {"area", [](const Ready& r) { return static_cast<double>(r.area); }},
    {"side", [](const Ready& r) { return static_cast<double>(std::max(r.shape.width, r.shape.height)); }},
}};

struct Try {
  std::size_t order = 0;
  int width = 0;
};

/// What a try found: no places where its page would have been larger than allowed.
struct Found {
  RectSize page;
  std::vector<RectPlace> places;
  std::int64_t area = std::numeric_limits<std::int64_t>::max();
};

class MaskSearch {
 public:
  MaskSearch(std::span<const MaskShape> shapes, const RectOptions& options) : options_(options) {
    for (const MaskShape& shape : shapes) {
      const Ready& ready = upright_.emplace_back(shape);
      if (options.rotate) turned_.emplace_back(turned(shape));
      area_ += ready.area;
      boxes_ += std::int64_t{shape.width} * shape.height;
      least_ = std::max(least_, options.rotate ? std::min(shape.width, shape.height) : shape.width);
    }
    for (const Order& order : orders) {
      std::vector<std::size_t>& indices = sorted_.emplace_back(shapes.size());
      std::iota(indices.begin(), indices.end(), std::size_t{0});
      std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        return order.key(upright_[a]) > order.key(upright_[b]);
      });
    }
  }

  Found run() {
    // The first look: every width by the first order.
    std::vector<Try> tries;
    const double middle = std::sqrt(static_cast<double>(area_) / usual_fill);
    for (int k = -widths_each_way; k <= widths_each_way; ++k)
      tries.push_back({0, rounded(static_cast<int>(middle * math::exp2(k / 7.0)))});
    std::vector<Try> good = compete(tries);
    // The best widths by all orders, then widths close to the best.
    tries.clear();
    for (std::size_t i = 0; i < std::min(good.size(), finalists); ++i)
      for (std::size_t order = 1; order < orders.size(); ++order) tries.push_back({order, good[i].width});
    good = compete(tries);
    tries.clear();
    for (int k = -neighbours; k <= neighbours && best_.area < none; ++k)
      if (k != 0) tries.push_back({won_.order, rounded(won_.width + 8 * k)});
    compete(tries);
    return std::move(best_);
  }
  std::string_view order() const { return orders[won_.order].name; }
  int tries() const { return tries_; }

 private:
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  static constexpr double usual_fill = 0.85;
  static constexpr int widths_each_way = 4, neighbours = 2;
  static constexpr std::size_t finalists = 2;

  int rounded(int side) const {
    const int multiple = options_.multiple;
    const int least = (least_ + multiple - 1) / multiple * multiple;
    return std::clamp((side + multiple - 1) / multiple * multiple, least,
                      std::max(least, options_.largest_side / multiple * multiple));
  }

  /// Makes the tries; the best is kept. All of them are measured against the best of those before, so that
  /// the threads do not matter. Returns those that were as good as any before, the best first.
  std::vector<Try> compete(const std::vector<Try>& tries) {
    std::vector<Found> found(tries.size());
    parallel_chunks(tries.size(), options_.threads, 1,
                    [&](std::size_t i, std::size_t, unsigned) { found[i] = packed(tries[i]); });
    tries_ += static_cast<int>(tries.size());
    std::vector<std::size_t> by_area(tries.size());
    std::iota(by_area.begin(), by_area.end(), std::size_t{0});
    std::stable_sort(by_area.begin(), by_area.end(),
                     [&](std::size_t a, std::size_t b) { return found[a].area < found[b].area; });
    std::vector<Try> out;
    for (const std::size_t i : by_area)
      if (found[i].area < none) out.push_back(tries[i]);
    if (!out.empty() && found[by_area[0]].area < best_.area) {
      best_ = std::move(found[by_area[0]]);
      won_ = out[0];
    }
    return out;
  }

  Found packed(const Try& of) const {
    // No page is looked for that is larger than the best so far, or than twice the boxes of the shapes.
    const std::int64_t most = std::min(best_.area, 2 * boxes_ + of.width * tallest());
    const auto height = static_cast<int>(std::min<std::int64_t>(options_.largest_side, most / of.width));
    Found out;
    out.places.resize(upright_.size());
    if (of.width > options_.largest_side || height < 1) return {};
    MaskPage page(of.width, height);
    int bottom = 0;
    for (const std::size_t i : sorted_[of.order]) {
      const auto place = put_lowest(page, upright_[i], options_.rotate ? &turned_[i] : nullptr, height);
      if (!place) return {};
      out.places[i] = *place;
      const MaskShape& shape = upright_[i].shape;
      bottom = std::max(bottom, place->y + (place->rotated ? shape.width : shape.height));
    }
    const int multiple = options_.multiple;
    out.page = {of.width, (bottom + multiple - 1) / multiple * multiple};
    if (out.page.height > options_.largest_side) return {};
    out.area = std::int64_t{out.page.width} * out.page.height;
    return out;
  }

  std::int64_t tallest() const {
    int out = 1;
    for (const Ready& each : upright_) out = std::max({out, each.shape.height, each.shape.width});
    return out;
  }

  const RectOptions& options_;
  std::vector<Ready> upright_, turned_;
  std::vector<std::vector<std::size_t>> sorted_;  // by order
  std::int64_t area_ = 0, boxes_ = 0;
  int least_ = 1, tries_ = 0;
  Found best_;
  Try won_;
};

}  // namespace

MaskShape turned(const MaskShape& shape) {
  std::vector<std::vector<bool>> rows(at(shape.width), std::vector<bool>(at(shape.height)));
  for (const RowRun& run : shape.runs)
    for (int x = run.begin; x < run.end; ++x) rows[at(x)][at(shape.height - 1 - run.row)] = true;
  MaskShape out{shape.height, shape.width, {}};
  for (int y = 0; y < out.height; ++y)
    add_row(out.runs, y, 0, out.width, [&](int x) { return bool{rows[at(y)][at(x)]}; });
  return out;
}

std::optional<RectLayout> pack_masks(std::span<const MaskShape> shapes, const RectOptions& options,
                                     const PreviousRects* previous) {
  if (shapes.empty()) return std::nullopt;
  if (previous != nullptr && previous->pages.size() == 1)
    if (std::optional<RectLayout> kept = rects::keep_masks(shapes, options, *previous)) return kept;
  std::optional<RectLayout> out;
  int tries = 0;
  for (const bool rotate : {false, true}) {
    if (rotate && !options.rotate) break;
    RectOptions way = options;
    way.rotate = rotate;
    MaskSearch search(shapes, way);
    Found found = search.run();
    tries += search.tries();
    if (found.page.width == 0 || (out && static_cast<std::int64_t>(out->page_texels()) <= found.area))
      continue;
    out.emplace();
    out->pages = {found.page};
    out->places = std::move(found.places);
    out->method = "outlines by " + std::string(search.order());
  }
  if (out) out->tries = tries;
  return out;
}

}  // namespace etak
