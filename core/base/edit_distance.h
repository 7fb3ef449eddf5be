// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace etak {

/// Levenshtein distance between names, upper and lower case of ASCII letters alike: for "did you mean".
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace etak
