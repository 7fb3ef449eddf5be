// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/components.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <tuple>

#include "core/color/luminance.h"

namespace etak {

namespace {

bool larger_first(const Plateau& a, const Plateau& b) {
  return std::tuple(b.area, a.box.y, a.box.x, a.box.width) <
         std::tuple(a.area, b.box.y, b.box.x, b.box.width);
}

// How the codes change beyond the end of a run: not at all, in few steps, or in many.
enum class End { border, hard, soft };

// The end of a run whose last code is *code, in the direction `step`, 1 or -1. It is hard where one step
// makes at least half of the change, as in drawn and anti-aliased edges. In edges that are blurred enough to
// leave a plateau, with sigma 2 and more, a step makes a quarter.
End end_of_run(const std::uint8_t* code, int step) {
  constexpr int noise = 8;  // codes
  int change = 0, largest_step = 0;
  for (int i = 1; i <= Components::edge_reach; ++i) {
    change = std::max(change, std::abs(code[step * i] - code[0]));
    largest_step = std::max(largest_step, std::abs(code[step * i] - code[step * (i - 1)]));
  }
  if (change <= noise) return End::border;
  return 2 * largest_step >= change ? End::hard : End::soft;
}

}  // namespace

Components::Components(RegionKind kind, const PixelBox& tile, std::size_t least_area, int eroded,
                       const CodeTables& tables)
    : kind_(kind), tile_(tile), least_area_(least_area), eroded_(eroded), tables_(tables) {}

std::uint32_t Components::root(std::uint32_t component) {
  while (parent_[component] != component) component = parent_[component] = parent_[parent_[component]];
  return component;
}

std::uint32_t Components::create() {
  std::uint32_t component;
  if (free_.empty()) {
    component = static_cast<std::uint32_t>(sums_.size());
    sums_.emplace_back();
    parent_.push_back(component);
  } else {
    component = free_.back();
    free_.pop_back();
    sums_[component] = {};
    parent_[component] = component;
  }
  open_.push_back(component);
  return component;
}

std::uint32_t Components::join(std::uint32_t a, std::uint32_t b) {
  a = root(a);
  b = root(b);
  if (a == b) return a;
  if (sums_[a].area < sums_[b].area) std::swap(a, b);
  Sums &to = sums_[a], &from = sums_[b];
  to.area += from.area;
  to.x0 = std::min(to.x0, from.x0);
  to.y0 = std::min(to.y0, from.y0);
  to.x1 = std::max(to.x1, from.x1);
  to.y1 = std::max(to.y1, from.y1);
  for (std::size_t i = 0; i < 3; ++i) {
    to.specular[i] += from.specular[i];
    to.diffuse[i] += from.diffuse[i];
  }
  to.metallic += from.metallic;
  to.least = std::min(to.least, from.least);
  to.most = std::max(to.most, from.most);
  to.hard_ends += from.hard_ends;
  to.soft_ends += from.soft_ends;
  to.touched = to.touched || from.touched;
  parent_[b] = a;
  return a;
}

void Components::add_run(int y, const Run& run, const RowPointers& rows, const std::uint8_t* codes) {
  Sums& sums = sums_[run.component];
  if (sums.area == 0) {
    sums.x0 = run.first;
    sums.x1 = run.last;
    sums.y0 = y;
  }
  sums.area += static_cast<std::size_t>(run.last - run.first + 1);
  sums.x0 = std::min(sums.x0, run.first);
  sums.x1 = std::max(sums.x1, run.last);
  sums.y1 = y;
  sums.touched = true;
  const auto add = [&](const std::uint8_t* row, std::array<std::uint64_t, 3>& to) {
    if (row == nullptr) return;
    for (int x = run.first; x <= run.last; ++x)
      for (std::size_t c = 0; c < 3; ++c) to[c] += tables_.linear[row[4 * x + static_cast<int>(c)]];
  };
  add(rows.b, sums.specular);
  add(rows.a, sums.diffuse);
  if (rows.metallic != nullptr)
    for (int x = run.first; x <= run.last; ++x) sums.metallic += rows.metallic[4 * x];
  for (int x = run.first; x <= run.last; ++x) {
    sums.least = std::min(sums.least, codes[x]);
    sums.most = std::max(sums.most, codes[x]);
  }
  if (kind_ != RegionKind::zone || sums.area >= least_area_) return;
  for (const End end : {end_of_run(codes + run.first, -1), end_of_run(codes + run.last, 1)}) {
    sums.hard_ends += end == End::hard;
    sums.soft_ends += end == End::soft;
  }
}

void Components::add_row(int y, const std::uint64_t* words, std::size_t word_count, const RowPointers& rows,
                         const std::uint8_t* codes) {
  current_.clear();
  for (std::size_t w = 0; w < word_count; ++w) {
    std::uint64_t bits = words[w];
    const int base = static_cast<int>(64 * w);
    while (bits != 0) {
      const int first = std::countr_zero(bits);
      const int length = std::countr_one(bits >> first);
      const int last = first + length - 1;
      if (!current_.empty() && first == 0 && current_.back().last == base - 1)
        current_.back().last = base + last;
      else
        current_.push_back({base + first, base + last, 0});
      bits = first + length >= 64 ? 0 : bits >> (first + length) << (first + length);
    }
  }
  std::size_t up = 0;
  for (Run& run : current_) {
    while (up < above_.size() && above_[up].last + 1 < run.first) ++up;
    bool found = false;
    for (std::size_t i = up; i < above_.size() && above_[i].first <= run.last + 1; ++i) {
      run.component = found ? join(run.component, above_[i].component) : root(above_[i].component);
      found = true;
    }
    if (!found) run.component = create();
    add_run(y, run, rows, codes);
  }
  for (Run& run : current_) run.component = root(run.component);
  above_.swap(current_);
  retire(false);
}

void Components::add_empty_row() {
  if (above_.empty()) return;
  above_.clear();
  retire(false);
}

void Components::retire(bool all) {
  std::size_t kept = 0;
  for (const auto component : open_) {
    Sums& sums = sums_[component];
    if (parent_[component] != component) {  // joined to another, and named by no run any more
      free_.push_back(component);
    } else if (sums.touched && !all) {
      sums.touched = false;
      open_[kept++] = component;
    } else {
      close(sums);
      free_.push_back(component);
    }
  }
  open_.resize(kept);
}

Plateau Components::plateau_of(const Sums& sums) const {
  Plateau plateau;
  plateau.kind = kind_;
  plateau.box = {tile_.x + sums.x0, tile_.y + sums.y0, sums.x1 - sums.x0 + 1, sums.y1 - sums.y0 + 1};
  plateau.area = sums.area;
  const double scale = 1 / (static_cast<double>(sums.area) * linear_one);
  for (std::size_t i = 0; i < 3; ++i) {
    plateau.specular[i] = static_cast<double>(sums.specular[i]) * scale;
    plateau.diffuse[i] = static_cast<double>(sums.diffuse[i]) * scale;
  }
  plateau.metallic = static_cast<double>(sums.metallic) / (255.0 * static_cast<double>(sums.area));
  plateau.least = sums.least;
  plateau.most = sums.most;
  return plateau;
}

// Looks for a solid patch in a component that is too small for a region. The component shows the size of a
// patch of 7 texels a side or more, because erosion and median leave a square that lacks three texels in each
// corner.
void Components::close_small(const Sums& sums) {
  constexpr int least_side = 7;
  constexpr std::size_t corners = 12;
  if (kind_ != RegionKind::zone || sums.hard_ends <= 3 * sums.soft_ends) return;
  const int left = std::max(0, sums.x0 - eroded_), right = std::min(tile_.width - 1, sums.x1 + eroded_);
  const int top = std::max(0, sums.y0 - eroded_), bottom = std::min(tile_.height - 1, sums.y1 + eroded_);
  const int width = right - left + 1, height = bottom - top + 1;
  const auto inner = static_cast<std::size_t>((sums.x1 - sums.x0 + 1) * (sums.y1 - sums.y0 + 1));
  if (std::min(width, height) < least_side || 4 * (sums.area + corners) < 3 * inner) return;
  Plateau patch = plateau_of(sums);
  patch.box = {tile_.x + left, tile_.y + top, width, height};
  ++result_.patches;
  result_.patch_area += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (result_.patches == 1 || larger_first(patch, result_.largest_patch)) result_.largest_patch = patch;
}

void Components::close(const Sums& sums) {
  if (sums.area < least_area_) return close_small(sums);
  const Plateau plateau = plateau_of(sums);

  result_.box = result_.regions == 0 ? plateau.box : around(result_.box, plateau.box);
  ++result_.regions;
  result_.area += plateau.area;
  result_.area_by_code.resize(256);
  result_.area_by_code[tables_.encode(luminance_of(plateau.specular))] += plateau.area;
  auto& largest = result_.largest;
  largest.push_back(plateau);
  if (largest.size() >= 2 * PlateauSummary::kept) {
    std::sort(largest.begin(), largest.end(), larger_first);
    largest.resize(PlateauSummary::kept);
  }
}

void Components::finish(PlateauSummary& summary) {
  retire(true);
  std::sort(result_.largest.begin(), result_.largest.end(), larger_first);
  if (result_.largest.size() > PlateauSummary::kept) result_.largest.resize(PlateauSummary::kept);
  result_.masked = summary.masked;
  result_.masked_box = summary.masked_box;
  summary = std::move(result_);
}

}  // namespace etak
