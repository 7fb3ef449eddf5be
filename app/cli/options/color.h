// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/color/rgb.h"

namespace etak::cli {

/// The numbers of "0.9,0.5,0.1"; none where one of them is no number.
std::vector<double> typed_numbers(std::string_view text);

/// A linear colour as typed: "0.9" (grey), "0.9,0.5,0.1", or "#e5b45f", whose codes are sRGB. Throws Error.
///   place   the option, for messages
LinearRgb typed_color(const std::string& place, std::string_view text);

/// Adds an option that takes such a colour.
void add_color_option(Command verb, const char* name, std::string& value, const char* help);

/// The same of a colour that is a share of light. Throws Error for a channel outside of 0 to 1.
LinearRgb typed_share(const std::string& place, std::string_view text);

/// The colour of --emission. Throws Error for a channel below 0.
LinearRgb typed_emission(std::string_view text);

}  // namespace etak::cli
