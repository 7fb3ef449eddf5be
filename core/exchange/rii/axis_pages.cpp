// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rii/axis_pages.h"

namespace etak {
namespace {

// Where a path tells of an axis: the tag is what stands in [begin, end).
struct TagPlace {
  const CrystalAxis* axis = nullptr;
  std::size_t begin = 0, end = 0;
};

TagPlace tag_place(std::string_view path) {
  const std::size_t stem_begin = path.rfind('/') + 1;  // npos + 1 is 0
  std::size_t end = path.rfind('.');
  if (end == path.npos || end < stem_begin) end = path.size();
  while (end > stem_begin) {
    const std::size_t dash = path.rfind('-', end - 1);
    if (dash == path.npos || dash < stem_begin) break;
    if (const CrystalAxis* axis = axis_named(path.substr(dash + 1, end - dash - 1)))
      return {axis, dash + 1, end};
    end = dash;
  }
  return {};
}

}  // namespace

const CrystalAxis* axis_of_page(std::string_view path) {
  return tag_place(path).axis;
}

std::vector<AxisPage> axis_pages(const std::string& path) {
  const TagPlace place = tag_place(path);
  if (place.axis == nullptr) return {};
  const std::string_view tag = std::string_view(path).substr(place.begin, place.end - place.begin);
  const auto member = tag == place.axis->tag ? &CrystalAxis::tag : &CrystalAxis::symbol;
  std::vector<AxisPage> out;
  for (const CrystalAxis& axis : axes_of_system(tag, member))
    out.push_back(
        {path.substr(0, place.begin) + std::string(axis.*member) + path.substr(place.end), axis.weight});
  return out;
}

}  // namespace etak
