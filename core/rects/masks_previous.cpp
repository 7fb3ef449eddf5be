// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "core/rects/mask_page.h"

namespace etak::rects {
namespace {

/// An earlier page with shapes that stay, and others that come.
class MaskCompletion {
 public:
  MaskCompletion(std::span<const MaskShape> shapes, const RectOptions& options, const PreviousRects& previous)
      : options_(options), page_(previous.pages[0]) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const std::optional<RectPlace>& old = previous.places[i];
      const bool may_stay = old && old->page == 0 && (options.rotate || !old->rotated);
      (may_stay ? staying_ : coming_)
          .push_back(
              {i, ReadyMask(shapes[i]), ReadyMask(etak::turned(shapes[i])), may_stay ? *old : RectPlace{}});
    }
    const auto larger = [](const Part& a, const Part& b) { return a.upright.area > b.upright.area; };
    std::stable_sort(coming_.begin(), coming_.end(), larger);
  }

  /// The page of the least area of several widths.
  std::optional<RectLayout> run() const {
    constexpr int steps = 8, of_width = 16;
    std::optional<RectLayout> best;
    for (int k = 0; k <= steps; ++k) {
      if (std::optional<RectLayout> layout = at_width(page_.width + page_.width * k / of_width);
          layout && (!best || layout->page_texels() < best->page_texels()))
        best = std::move(layout);
      if (coming_.empty()) break;
    }
    return best;
  }

 private:
  struct Part {
    std::size_t index;
    ReadyMask upright, turned;
    RectPlace old;
    const ReadyMask& lying(bool rotated) const { return rotated ? turned : upright; }
  };

  int rounded(int side) const {
    return (side + options_.multiple - 1) / options_.multiple * options_.multiple;
  }

  std::optional<RectLayout> at_width(int width) const {
    const int most_width = std::min(rounded(width), options_.largest_side);
    std::int64_t more = 0;  // rows that all that comes would take, one above the other
    for (const Part& part : coming_) more += std::max(part.upright.shape.width, part.upright.shape.height);
    const auto height = static_cast<int>(
        std::min<std::int64_t>(options_.largest_side, std::int64_t{2} * page_.height + more));
    MaskPage page(most_width, height);
    RectLayout out;
    out.places.resize(staying_.size() + coming_.size());
    RectSize used;
    const auto take = [&](const Part& part, const RectPlace& place) {
      const MaskShape& shape = part.lying(place.rotated).shape;
      out.places[part.index] = place;
      used = {std::max(used.width, place.x + shape.width), std::max(used.height, place.y + shape.height)};
    };
    std::vector<const Part*> left;
    for (const Part& part : staying_) {
      const MaskShape& shape = part.lying(part.old.rotated).shape;
      const MaskSpot spot{part.old.x, part.old.y};
      if (!page.is_free(shape, spot)) {
        left.push_back(&part);
        continue;
      }
      page.put(shape, spot);
      take(part, part.old);
    }
    if (left.size() == staying_.size()) return std::nullopt;
    for (const Part& part : coming_) left.push_back(&part);
    for (const Part* part : left) {
      const auto place = put_lowest(page, part->upright, options_.rotate ? &part->turned : nullptr, height);
      if (!place) return std::nullopt;
      take(*part, *place);
    }
    out.pages = {{rounded(used.width), rounded(used.height)}};
    if (std::max(out.pages[0].width, out.pages[0].height) > options_.largest_side) return std::nullopt;
    out.method = "outlines kept; new ones into gaps";
    out.tries = 1;
    out.kept_previous = true;
    return out;
  }

  const RectOptions& options_;
  RectSize page_;
  std::vector<Part> staying_, coming_;
};

}  // namespace

std::optional<RectLayout> keep_masks(std::span<const MaskShape> shapes, const RectOptions& options,
                                     const PreviousRects& previous) {
  return MaskCompletion(shapes, options, previous).run();
}

}  // namespace etak::rects
