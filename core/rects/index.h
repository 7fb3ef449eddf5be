// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak::rects {

/// An index or a count as containers take it; this folder keeps both as int, as it does lengths. i: not
/// negative.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace etak::rects
