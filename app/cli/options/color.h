// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/render/typed.h"

namespace etak::cli {

/// Adds an option that takes such a colour.
void add_color_option(Command verb, const char* name, std::string& value, const char* help);

/// The colour of --emission. Throws Error for a channel below 0.
LinearRgb typed_emission(std::string_view text);

}  // namespace etak::cli
