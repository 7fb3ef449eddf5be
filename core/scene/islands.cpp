// SPDX-License-Identifier: Apache-2.0
// Islands: triangles are split in two again and again, as for a bounding volume hierarchy. The tree is cut
// where the boxes below take the fewest texels; then boxes are joined that take fewer texels as one.
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <map>
#include <queue>
#include <span>

#include "core/scene/uv_use.h"

namespace etak {
namespace {

using Area = std::int64_t;

/// Columns and rows, last ones included; empty when right < left.
struct Box {
  int left = std::numeric_limits<int>::max(), top = left, right = -1, bottom = -1;

  void add(const Box& b) {
    left = std::min(left, b.left);
    top = std::min(top, b.top);
    right = std::max(right, b.right);
    bottom = std::max(bottom, b.bottom);
  }
};
Box bounds_of(Box a, const Box& b) {
  a.add(b);
  return a;
}

class Splitter {
 public:
  Splitter(const TexelUse& use, int margin, Area per_box)
      : width_(use.width), height_(use.height), margin_(margin), per_box_(per_box) {
    boxes_.reserve(use.footprints.size());
    for (const auto& f : use.footprints) boxes_.push_back({f[0], f[1], f[2], f[3]});
  }

  std::vector<Box> run() {
    split(boxes_, 0);
    return std::move(chosen_);
  }

  /// With the margin, inside the texture.
  Box grown(const Box& b) const {
    return {std::max(0, b.left - margin_), std::max(0, b.top - margin_),
            std::min(width_ - 1, b.right + margin_), std::min(height_ - 1, b.bottom + margin_)};
  }
  Area area(const Box& box) const {
    const Box b = grown(box);
    return static_cast<Area>(b.right - b.left + 1) * static_cast<Area>(b.bottom - b.top + 1);
  }

 private:
  static constexpr int bins = 16;
  static constexpr int deepest = 64;  // of the recursion; splits of equal shares never come near

  /// Chooses boxes for these triangles, appends them to chosen_ and returns what they cost.
  Area split(std::span<Box> triangles, int depth) {
    Box whole;
    for (const Box& b : triangles) whole.add(b);
    const Area as_one = area(whole) + per_box_;
    const std::size_t before = chosen_.size();
    // Two boxes hold at least one texel each.
    const Area least = 2 * (per_box_ + 1);
    std::size_t left = 0;
    if (as_one >= least && depth < deepest) left = parted(triangles, whole);
    if (left > 0) {
      const Area parts = split(triangles.first(left), depth + 1) + split(triangles.subspan(left), depth + 1);
      if (parts <= as_one) return parts;
    }
    chosen_.resize(before);
    chosen_.push_back(whole);
    return as_one;
  }

  /// Parts the triangles by their centres where the boxes of the two sides are smallest in sum; returns how
  /// many are on the first side, 0 when all centres agree.
  std::size_t parted(std::span<Box> triangles, const Box& whole) {
    Area best = std::numeric_limits<Area>::max();
    int best_axis = -1, best_bin = 0;
    for (int axis = 0; axis < 2; ++axis) {
      std::array<Box, bins> bin;
      const Bins bin_of(whole, axis);
      for (const Box& b : triangles) bin[bin_of.of(b)].add(b);
      std::array<Area, bins> above{};
      Box sum;
      for (int i = bins; i-- > 1;) {
        sum.add(bin[static_cast<std::size_t>(i)]);
        above[static_cast<std::size_t>(i)] = sum.right < 0 ? -1 : area(sum);
      }
      sum = {};
      for (int i = 0; i + 1 < bins; ++i) {
        sum.add(bin[static_cast<std::size_t>(i)]);
        const Area rest = above[static_cast<std::size_t>(i) + 1];
        if (sum.right < 0 || rest < 0) continue;
        if (const Area both_sides = area(sum) + rest; both_sides < best) {
          best = both_sides;
          best_axis = axis;
          best_bin = i;
        }
      }
    }
    if (best_axis < 0) return 0;
    const Bins bin_of(whole, best_axis);
    const auto middle = std::stable_partition(triangles.begin(), triangles.end(), [&](const Box& b) {
      return bin_of.of(b) <= static_cast<std::size_t>(best_bin);
    });
    return static_cast<std::size_t>(middle - triangles.begin());
  }

  /// Which of the equal bins along an axis of a box the centre of another one lies in.
  struct Bins {
    int axis, from;
    std::uint64_t scale;  // bins per half texel, times 2^32
    Bins(const Box& whole, int axis_)
        : axis(axis_),
          from(axis == 0 ? 2 * whole.left : 2 * whole.top),
          scale((std::uint64_t{bins} << 32) / static_cast<std::uint64_t>(size(whole))) {}
    int size(const Box& b) const {
      return axis == 0 ? 2 * (b.right - b.left) + 1 : 2 * (b.bottom - b.top) + 1;
    }
    std::size_t of(const Box& b) const {
      const int twice = (axis == 0 ? b.left + b.right : b.top + b.bottom) - from;
      return static_cast<std::uint64_t>(twice) * scale >> 32;
    }
  };

  int width_, height_, margin_;
  Area per_box_;
  std::vector<Box> boxes_, chosen_;
};

/// Joins the pair that gains most, again and again, while one box costs no more than two.
void join(const Splitter& sizes, Area per_box, std::vector<Box>& boxes) {
  struct Pair {
    Area cost;  // of joining: less is better
    std::size_t a, b;
    bool operator<(const Pair& other) const {
      if (cost != other.cost) return cost > other.cost;
      return a != other.a ? a > other.a : b > other.b;
    }
  };
  // All pairs are compared. With more boxes than this that takes too long, and the tree has saved most
  // already.
  constexpr std::size_t most_boxes = 2048;
  if (boxes.size() > most_boxes) return;
  std::priority_queue<Pair> pairs;
  std::vector<bool> gone(boxes.size(), false);
  const auto consider = [&](std::size_t a, std::size_t b) {
    const Area cost = sizes.area(bounds_of(boxes[a], boxes[b])) - sizes.area(boxes[a]) - sizes.area(boxes[b]);
    if (cost < per_box) pairs.push({cost, a, b});
  };
  for (std::size_t b = 1; b < boxes.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) consider(a, b);
  while (!pairs.empty()) {
    const Pair pair = pairs.top();
    pairs.pop();
    if (gone[pair.a] || gone[pair.b]) continue;
    gone[pair.a] = gone[pair.b] = true;
    boxes.push_back(bounds_of(boxes[pair.a], boxes[pair.b]));
    gone.push_back(false);
    for (std::size_t a = 0; a + 1 < boxes.size(); ++a)
      if (!gone[a]) consider(a, boxes.size() - 1);
  }
  std::size_t to = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!gone[i]) boxes[to++] = boxes[i];
  boxes.resize(to);
}

/// The number of the connected part (texels that share a side) of each texel of the mask, from 1 on.
std::vector<int> parts_of(const TexelUse& use) {
  const int width = use.width, height = use.height;
  std::vector<int> out(use.mask.size(), 0), open;
  int parts = 0;
  const auto visit = [&](int texel) {
    const auto i = static_cast<std::size_t>(texel);
    if (use.mask[i] == 0 || out[i] != 0) return;
    out[i] = parts;
    open.push_back(texel);
  };
  for (int first = 0; first < width * height; ++first) {
    if (use.mask[static_cast<std::size_t>(first)] == 0 || out[static_cast<std::size_t>(first)] != 0) continue;
    ++parts;
    visit(first);
    while (!open.empty()) {
      const int texel = open.back(), column = texel % width;
      open.pop_back();
      if (column > 0) visit(texel - 1);
      if (column + 1 < width) visit(texel + 1);
      if (texel >= width) visit(texel - width);
      if (texel < width * (height - 1)) visit(texel + width);
    }
  }
  return out;
}

}  // namespace

std::vector<Outline> outlines(const TexelUse& use, std::size_t merge_cost) {
  const std::vector<int> parts = parts_of(use);
  const auto part_at = [&](int column, int row) {
    return parts[static_cast<std::size_t>(row) * static_cast<std::size_t>(use.width) +
                 static_cast<std::size_t>(column)];
  };
  std::map<int, TexelUse> by_part;
  for (std::size_t i = 0; i < use.footprints.size(); ++i)
    by_part[part_at(use.centres[i][0], use.centres[i][1])].footprints.push_back(use.footprints[i]);
  std::vector<Outline> out;
  for (auto& [part, of] : by_part) {
    of.width = use.width;
    of.height = use.height;
    for (const Island& box : islands(of, 0, merge_cost)) {
      Outline& outline = out.emplace_back(Outline{box, {}});
      for (int y = box.y; y < box.y + box.height; ++y)
        add_row(outline.texels, y, box.x, box.x + box.width,
                [&, of_part = part](int x) { return part_at(x, y) == of_part; });
    }
  }
  const auto key = [](const Outline& o) { return std::array{o.box.y, o.box.x, o.box.width, o.box.height}; };
  std::ranges::stable_sort(out, {}, key);
  return out;
}

std::vector<Island> islands(const TexelUse& use, int margin, std::size_t merge_cost) {
  assert(margin >= 0);
  const auto per_box = static_cast<Area>(std::min<std::uint64_t>(merge_cost, std::uint64_t{1} << 40));
  Splitter splitter(use, margin, per_box);
  std::vector<Box> boxes;
  if (!use.footprints.empty()) {
    boxes = splitter.run();
    join(splitter, per_box, boxes);
  } else if (use.touched > 0 || use.tiles) {
    boxes.push_back({use.box[0], use.box[1], use.box[0] + use.box[2] - 1, use.box[1] + use.box[3] - 1});
  }
  std::vector<Island> out;
  for (const Box& box : boxes) {
    const Box b = splitter.grown(box);
    out.push_back({b.left, b.top, b.right - b.left + 1, b.bottom - b.top + 1});
  }
  std::sort(out.begin(), out.end(), [](const Island& a, const Island& b) {
    return std::array{a.y, a.x, a.width, a.height} < std::array{b.y, b.x, b.width, b.height};
  });
  return out;
}

}  // namespace etak
