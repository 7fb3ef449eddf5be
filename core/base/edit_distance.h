// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace etak {

/// Edits from one name to the other: a letter put in, left out or replaced, or two neighbours exchanged, each
/// counted once (optimal string alignment). Upper and lower case of ASCII letters are alike. For "did you
/// mean".
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace etak
