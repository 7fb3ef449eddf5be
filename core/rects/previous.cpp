// SPDX-License-Identifier: Apache-2.0
#include "core/rects/previous.h"

#include <algorithm>
#include <climits>
#include <tuple>

#include "core/rects/pack.h"

namespace etak::rects {
namespace {

int up(int value, int step) {
  return (value + step - 1) / step * step;
}

// Rectangles that stay and those that need a place, the largest first.
struct Split {
  std::vector<std::size_t> staying, coming;
};

Split split(std::span<const RectSize> sizes, const RectOptions& options, const PreviousRects& previous) {
  Split out;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto& place = i < previous.places.size() ? previous.places[i] : std::nullopt;
    const bool usable = place && (options.rotate || !place->rotated) && place->x % options.align == 0 &&
                        place->y % options.align == 0;
    (usable ? out.staying : out.coming).push_back(i);
  }
  std::sort(out.coming.begin(), out.coming.end(), [&](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t i) {
      return std::make_tuple(-std::int64_t{sizes[i].width} * sizes[i].height,
                             -std::max(sizes[i].width, sizes[i].height), -sizes[i].width, i);
    };
    return rank(a) < rank(b);
  });
  return out;
}

class Gaps {
 public:
  Gaps(std::span<const RectSize> sizes, const RectOptions& options, const PreviousRects& previous,
       const Split& parts)
      : sizes_(sizes), options_(options), previous_(previous), parts_(parts) {
    // From below and from the left: then there are few free rectangles at a time.
    sorted_ = parts.staying;
    std::sort(sorted_.begin(), sorted_.end(), [&](std::size_t a, std::size_t b) {
      const RectPlace &p = *previous_.places[a], &q = *previous_.places[b];
      return std::tie(p.page, p.y, p.x) < std::tie(q.page, q.y, q.x);
    });
  }

  // Puts the coming rectangles into pages of these sizes; those that found no place are returned.
  std::vector<std::size_t> place(const std::vector<RectSize>& pages, RectLayout& layout) const {
    std::vector<std::size_t> left = parts_.coming;
    for (std::size_t p = 0; p < pages.size() && !left.empty(); ++p) {
      const int align = options_.align;
      int least_width = INT_MAX, least_height = INT_MAX;
      for (const std::size_t i : left) {
        const int w = up(sizes_[i].width, align), h = up(sizes_[i].height, align);
        least_width = std::min(least_width, options_.rotate ? std::min(w, h) : w);
        least_height = std::min(least_height, options_.rotate ? std::min(w, h) : h);
      }
      const Set none;
      MaxRects space(none, options_.rotate);
      // A page side that is no multiple of the alignment: what reaches over is cut by the check below.
      space.begin(up(pages[p].width, align), up(pages[p].height, align), least_width, least_height);
      for (const std::size_t i : sorted_) {
        const RectPlace& old = *previous_.places[i];
        if (at(old.page) != p) continue;
        const int w = old.rotated ? sizes_[i].height : sizes_[i].width;
        const int h = old.rotated ? sizes_[i].width : sizes_[i].height;
        space.occupy(old.x, old.y, up(w, align), up(h, align));
      }
      std::vector<std::size_t> rest;
      for (const std::size_t i : left) {
        Spot spot;
        const bool fits =
            space.insert(up(sizes_[i].width, align), up(sizes_[i].height, align), Fit::short_side, spot);
        const int w = spot.rotated ? sizes_[i].height : sizes_[i].width;
        const int h = spot.rotated ? sizes_[i].width : sizes_[i].height;
        if (!fits || spot.x + w > pages[p].width || spot.y + h > pages[p].height) {
          rest.push_back(i);
          continue;
        }
        const bool turned = spot.rotated && sizes_[i].width != sizes_[i].height;
        layout.places[i] = {static_cast<int>(p), spot.x, spot.y, turned};
      }
      left.swap(rest);
    }
    return left;
  }

 private:
  std::span<const RectSize> sizes_;
  const RectOptions& options_;
  const PreviousRects& previous_;
  const Split& parts_;
  std::vector<std::size_t> sorted_;
};

// Page sizes to try when the gaps of a single page do not suffice, by rising texels; never above `most`
// texels, where the fresh layout is preferred anyway.
std::vector<RectSize> larger(const RectSize& page, const RectOptions& options, double most) {
  std::vector<RectSize> out;
  const auto offer = [&](std::int64_t w, std::int64_t h) {
    if (w > options.largest_side || (h > options.largest_side) ||
        static_cast<double>(w) * static_cast<double>(h) > most)
      return;
    out.push_back({static_cast<int>(w), static_cast<int>(h)});
  };
  constexpr int steps = 48;
  const int step = std::max(options.multiple, options.align);
  for (int k = 1; k <= steps; ++k) {
    // Up to twice the side, finely at first.
    const auto longer = [&](int side) {
      return up(side + std::max(k, side * k * k / (steps * steps)), step);
    };
    switch (options.form) {
      case PageForm::square:
        offer(longer(page.width), longer(page.width));
        break;
      case PageForm::strip:
        offer(page.width, longer(page.height));
        break;
      case PageForm::free:
        offer(page.width, longer(page.height));
        offer(longer(page.width), page.height);
        break;
      case PageForm::power_of_two:
        if (k == 1) {
          offer(page.width, std::int64_t{2} * page.height);
          offer(std::int64_t{2} * page.width, page.height);
          offer(std::int64_t{2} * page.width, std::int64_t{2} * page.height);
        }
        break;
      default:
        break;
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const RectSize& a, const RectSize& b) {
    return std::int64_t{a.width} * a.height < std::int64_t{b.width} * b.height;
  });
  return out;
}

// The previous layout with the new rectangles, or none where it cannot be used or takes more than `most`
// texels.
std::optional<RectLayout> completed(std::span<const RectSize> sizes, const RectOptions& options,
                                    const PreviousRects& previous, double most) {
  const Split parts = split(sizes, options, previous);
  if (parts.staying.empty()) return std::nullopt;
  RectLayout out;
  out.places.resize(sizes.size());
  out.pages = previous.pages;
  std::vector<RectSize> staying_sizes;
  RectLayout staying;
  staying.pages = previous.pages;
  for (const std::size_t i : parts.staying) {
    out.places[i] = *previous.places[i];
    staying_sizes.push_back(sizes[i]);
    staying.places.push_back(*previous.places[i]);
  }
  if (layout_fault(staying_sizes, staying)) return std::nullopt;
  const bool several = options.form == PageForm::pages || options.form == PageForm::mixed;
  if (!several && previous.pages.size() != 1) return std::nullopt;
  for (const RectSize& page : previous.pages) {
    const int widest = several || options.form == PageForm::strip ? options.side : options.largest_side;
    if (page.width > widest || page.height > (several ? options.side : options.largest_side))
      return std::nullopt;
  }

  const Gaps gaps(sizes, options, previous, parts);
  std::vector<std::size_t> left = gaps.place(out.pages, out);
  if (!left.empty() && !several) {
    for (const RectSize& page : larger(out.pages[0], options, most)) {
      out.pages[0] = page;
      left = gaps.place(out.pages, out);
      if (left.empty()) break;
    }
    if (!left.empty()) return std::nullopt;
  }
  if (!left.empty()) {  // further pages for the rest
    std::vector<RectSize> rest;
    for (const std::size_t i : left) rest.push_back(sizes[i]);
    const RectLayout more = pack_fresh(rest, options);
    const int before = static_cast<int>(out.pages.size());
    for (std::size_t k = 0; k < left.size(); ++k) {
      out.places[left[k]] = more.places[k];
      out.places[left[k]].page += before;
    }
    out.pages.insert(out.pages.end(), more.pages.begin(), more.pages.end());
  }
  drop_empty(out.pages, out.places, [](RectPlace& place) -> int& { return place.page; });
  fit_pages(sizes, options, out);
  return out;
}

}  // namespace

RectLayout keep_previous(std::span<const RectSize> sizes, const RectOptions& options,
                         const PreviousRects& previous, RectLayout fresh) {
  const double allowed =
      static_cast<double>(fresh.page_texels()) * (1 + std::max(0.0, previous.most_extra_area));
  std::optional<RectLayout> kept;
  if (!sizes.empty()) kept = completed(sizes, options, previous, allowed);
  RectLayout out = fresh;
  if (kept && static_cast<double>(kept->page_texels()) <= allowed) {
    out.pages = std::move(kept->pages);
    out.places = std::move(kept->places);
    out.kept_previous = true;
    out.method = "kept; new ones into gaps";
  }
  for (std::size_t i = 0; i < sizes.size() && i < previous.places.size(); ++i)
    if (previous.places[i] && *previous.places[i] != out.places[i]) ++out.moved;
  return out;
}

}  // namespace etak::rects
