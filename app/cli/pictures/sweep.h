// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/pictures/render.h"
#include "core/image/image.h"

namespace etak::cli {

/// The values of --sweep, NAME=FIRST:LAST:COUNT (numbers at even steps) or NAME=VALUE,VALUE,..., at most 64. Throws Error.
struct Sweep {
  std::string name;
  std::vector<std::string> values;
};
Sweep parse_sweep(const std::string& text);

/// The options with one value of the sweep in their place.
RenderArguments with_value(const RenderArguments& arguments, const Sweep& sweep, const std::string& value);

/// Draws the objects of a sweep side by side, each under its value.
///   drawn   the picture of one of them
Image draw_sweep(const RenderArguments& arguments, const std::function<Image(RenderArguments&)>& drawn);

}  // namespace etak::cli
