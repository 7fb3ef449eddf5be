// SPDX-License-Identifier: Apache-2.0
#include "core/rects/portfolio.h"

namespace etak::rects {
namespace {

constexpr Try best_fit(Key key, int transposed, int window, int side, int left_over, int late) {
  Try out;
  out.key = key;
  out.transposed = transposed != 0;
  out.rule.window = window;
  out.rule.side = side;
  out.rule.left_over = left_over;
  out.rule.late = late;
  return out;
}

constexpr Try max_rects(Key key, int transposed, Fit fit) {
  Try out;
  out.skyline = false;
  out.key = key;
  out.transposed = transposed != 0;
  out.fit = fit;
  return out;
}

// Found by packing some 60 sets of ten families under about 1,700 tries each, and taking again and again the
// try that adds most density per time to those taken before. Of few_upright some were then put further in front,
// which sets of some hundreds come to within the default effort: thin strips and trimmed sprites got denser by it,
// and none of the published sets less dense.

// clang-format off
constexpr Try few_upright[] = {
    best_fit(Key::height, 0, 4, 1, 1, 4),
    best_fit(Key::area, 0, 64, 1, 0, 4),
    max_rects(Key::height, 0, Fit::bottom_left),
    max_rects(Key::height, 1, Fit::bottom_left),
    max_rects(Key::short_side, 0, Fit::short_side),
    max_rects(Key::height, 0, Fit::short_side),
    max_rects(Key::area, 1, Fit::contact),
    max_rects(Key::long_side, 0, Fit::contact),
    best_fit(Key::height, 0, 256, 1, 1, 4),
    best_fit(Key::area, 0, 256, 1, 0, 4),
    best_fit(Key::ratio, 0, 64, 1, 0, 4),
    best_fit(Key::perimeter, 0, 64, 1, 0, 4),
    best_fit(Key::area, 1, 256, 1, 0, 0),
    best_fit(Key::long_side, 1, 4, 1, 0, 4),
    best_fit(Key::height, 0, 64, 2, 0, 0),
    best_fit(Key::difference, 1, 64, 0, 1, 0),
    best_fit(Key::short_side, 1, 16, 1, 0, 0),
    max_rects(Key::long_side, 0, Fit::short_side),
    best_fit(Key::area, 0, 4, 1, 1, 0),
    max_rects(Key::perimeter, 0, Fit::contact),
    best_fit(Key::area, 0, 16, 1, 0, 4),
    best_fit(Key::short_side, 1, 16, 0, 0, 0),
    best_fit(Key::height, 1, 256, 2, 0, 4),
    best_fit(Key::area, 1, 4, 1, 0, 4),
    best_fit(Key::area, 1, 256, 1, 0, 4),
    best_fit(Key::perimeter, 1, 4, 1, 0, 0),
    best_fit(Key::short_side, 1, 256, 1, 0, 0),
    max_rects(Key::width, 1, Fit::short_side),
    max_rects(Key::perimeter, 1, Fit::contact),
    max_rects(Key::area, 0, Fit::contact),
    max_rects(Key::short_side, 1, Fit::contact),
    max_rects(Key::difference, 1, Fit::contact),
};

constexpr Try few_turned[] = {
    best_fit(Key::perimeter, 0, 4, 1, 1, 4),
    best_fit(Key::area, 1, 64, 1, 0, 4),
    max_rects(Key::short_side, 0, Fit::bottom_left),
    best_fit(Key::difference, 0, 16, 2, 1, 4),
    best_fit(Key::perimeter, 0, 16, 1, 0, 4),
    max_rects(Key::short_side, 0, Fit::short_side),
    max_rects(Key::perimeter, 0, Fit::short_side),
    best_fit(Key::area, 0, 64, 0, 1, 0),
    best_fit(Key::short_side, 0, 64, 0, 0, 4),
    best_fit(Key::area, 1, 256, 1, 0, 0),
    best_fit(Key::short_side, 0, 4, 1, 0, 0),
    best_fit(Key::height, 1, 64, 0, 1, 4),
    best_fit(Key::perimeter, 0, 256, 0, 0, 0),
    max_rects(Key::width, 0, Fit::short_side),
    max_rects(Key::difference, 0, Fit::short_side),
    best_fit(Key::short_side, 1, 4, 1, 0, 4),
    best_fit(Key::area, 1, 256, 0, 0, 0),
    best_fit(Key::area, 1, 256, 1, 0, 4),
    max_rects(Key::perimeter, 0, Fit::contact),
    best_fit(Key::difference, 0, 256, 1, 0, 0),
    best_fit(Key::area, 1, 64, 1, 0, 0),
    best_fit(Key::short_side, 1, 64, 1, 0, 0),
    best_fit(Key::area, 0, 256, 1, 0, 4),
    max_rects(Key::long_side, 1, Fit::short_side),
    max_rects(Key::long_side, 1, Fit::contact),
    best_fit(Key::short_side, 1, 16, 1, 0, 4),
    max_rects(Key::height, 0, Fit::contact),
    max_rects(Key::area, 0, Fit::contact),
    max_rects(Key::short_side, 1, Fit::contact),
};

constexpr Try many_upright[] = {
    best_fit(Key::height, 0, 64, 1, 0, 0),
    best_fit(Key::height, 0, 1000, 1, 0, 0),
    max_rects(Key::height, 0, Fit::bottom_left),
    best_fit(Key::perimeter, 1, 64, 0, 0, 4),
    best_fit(Key::short_side, 0, 1000, 1, 0, 4),
    best_fit(Key::area, 0, 256, 1, 0, 0),
    best_fit(Key::short_side, 0, 256, 1, 0, 4),
    best_fit(Key::perimeter, 0, 16, 1, 0, 0),
    best_fit(Key::short_side, 1, 1000, 1, 0, 4),
    best_fit(Key::height, 1, 1000, 1, 0, 4),
    max_rects(Key::height, 1, Fit::bottom_left),
    best_fit(Key::width, 0, 64, 0, 0, 0),
    best_fit(Key::height, 0, 256, 1, 0, 0),
    max_rects(Key::height, 0, Fit::short_side),
    best_fit(Key::height, 0, 1000, 0, 0, 0),
    max_rects(Key::long_side, 0, Fit::short_side),
    best_fit(Key::perimeter, 0, 256, 1, 0, 0),
    best_fit(Key::height, 1, 1000, 1, 0, 0),
    max_rects(Key::short_side, 0, Fit::area),
};

constexpr Try many_turned[] = {
    best_fit(Key::area, 0, 256, 1, 0, 4),
    best_fit(Key::height, 0, 1000, 1, 0, 0),
    best_fit(Key::area, 0, 16, 1, 0, 0),
    best_fit(Key::area, 0, 1000, 1, 0, 0),
    best_fit(Key::short_side, 0, 256, 0, 0, 4),
    max_rects(Key::short_side, 1, Fit::bottom_left),
    best_fit(Key::short_side, 0, 256, 0, 0, 0),
    best_fit(Key::area, 0, 1000, 0, 0, 4),
    best_fit(Key::perimeter, 0, 256, 1, 0, 4),
    best_fit(Key::short_side, 1, 1000, 1, 1, 4),
    best_fit(Key::area, 0, 1000, 0, 1, 4),
    max_rects(Key::short_side, 0, Fit::short_side),
    best_fit(Key::width, 0, 1000, 1, 1, 4),
    max_rects(Key::long_side, 0, Fit::short_side),
    best_fit(Key::area, 1, 1000, 0, 0, 0),
    best_fit(Key::short_side, 0, 1000, 0, 0, 0),
};
// clang-format on

// Above this many the list of free rectangles costs more than its density is worth.
constexpr int most_for_maxrects = 5000;

}  // namespace

std::string Try::name() const {
  std::string out = skyline ? "best-fit skyline, window " + std::to_string(rule.window)
                            : std::string("MaxRects, ") + name_of(fit);
  out += std::string(", by ") + name_of(key);
  if (transposed) out += ", columns";
  return out;
}

std::vector<Try> portfolio(int n, bool rotate) {
  const bool few = n <= most_few;
  const std::span<const Try> all = few      ? rotate ? std::span<const Try>(few_turned) : few_upright
                                   : rotate ? std::span<const Try>(many_turned)
                                            : many_upright;
  std::vector<Try> out;
  for (const Try& how : all)
    if (how.skyline || n <= most_for_maxrects) out.push_back(how);
  return out;
}

std::vector<Try> every_max_rects() {
  std::vector<Try> out;
  for (int key = 0; key < key_count; ++key)
    for (const Fit fit : {Fit::short_side, Fit::area, Fit::bottom_left, Fit::contact})
      for (const int transposed : {0, 1}) out.push_back(max_rects(static_cast<Key>(key), transposed, fit));
  return out;
}

}  // namespace etak::rects
