// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/material/optics/axes.h"

namespace etak {

/// A page of one axis of a crystal.
///   weight   of CrystalAxis
struct AxisPage {
  std::string path;
  double weight = 1;
};

/// The axis that one of the parts of a page's file name behind a dash names ("Malitson-o", "Zheng-o-21C";
/// alpha, beta, gamma likewise); of several the last, for an author's initial may come before it. Null: none.
const CrystalAxis* axis_of_page(std::string_view path);

/// The pages of all axes of the crystal that `path` describes one axis of. Files are not looked for. Empty
/// where the name has no axis.
std::vector<AxisPage> axis_pages(const std::string& path);

}  // namespace etak
