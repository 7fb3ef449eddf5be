// SPDX-License-Identifier: Apache-2.0
#include "core/rects/set.h"

#include <algorithm>
#include <numeric>

namespace etak::rects {

Set::Set(std::vector<RectSize> canonical) : items(std::move(canonical)) {
  if (!items.empty()) width_step = height_step = 0;
  for (const RectSize& item : items) {
    width_step = std::gcd(width_step, item.width);
    height_step = std::gcd(height_step, item.height);
    longest_side = std::max({longest_side, item.width, item.height});
    area += std::int64_t{item.width} * item.height;
    widest = std::max(widest, item.width);
    tallest = std::max(tallest, item.height);
    longest_short_side = std::max(longest_short_side, std::min(item.width, item.height));
  }
}

Set Set::turned() const {
  std::vector<RectSize> swapped = items;
  for (RectSize& item : swapped) std::swap(item.width, item.height);
  return Set(std::move(swapped));
}

const char* name_of(Key key) {
  switch (key) {
    case Key::height:
      return "height";
    case Key::width:
      return "width";
    case Key::area:
      return "area";
    case Key::long_side:
      return "long side";
    case Key::short_side:
      return "short side";
    case Key::perimeter:
      return "perimeter";
    case Key::difference:
      return "difference of sides";
    case Key::ratio:
      return "ratio of sides";
  }
  return "";
}

namespace {

std::int64_t value_of(const RectSize& item, Key key) {
  const std::int64_t w = item.width, h = item.height;
  switch (key) {
    case Key::height:
      return h << 32 | w;
    case Key::width:
      return w << 32 | h;
    case Key::area:
      return w * h;
    case Key::long_side:
      return std::max(w, h) << 32 | std::min(w, h);
    case Key::short_side:
      return std::min(w, h) << 32 | std::max(w, h);
    case Key::perimeter:
      return w + h;
    case Key::difference:
      return std::max(w, h) - std::min(w, h);
    case Key::ratio:
      return (std::max(w, h) << 16) / std::min(w, h);
  }
  return 0;
}

}  // namespace

std::vector<int> ordered(const Set& set, std::span<const int> members, Key key) {
  struct Keyed {
    std::int64_t value;
    int index;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(members.size());
  for (const int i : members) keyed.push_back({value_of(set.items[static_cast<std::size_t>(i)], key), i});
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    return a.value != b.value ? a.value > b.value : a.index < b.index;
  });
  std::vector<int> out;
  out.reserve(keyed.size());
  for (const Keyed& k : keyed) out.push_back(k.index);
  return out;
}

}  // namespace etak::rects
