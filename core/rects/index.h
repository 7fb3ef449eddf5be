// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak::rects {

/// An index or a count, which this room keeps as an int beside lengths, as the containers want it. i: not negative.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace etak::rects
