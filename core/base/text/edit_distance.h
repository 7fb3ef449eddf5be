// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// A name of more bytes is misspelt from no other one, and gets no suggestion: to compare two names takes time in
/// proportion to the product of their lengths.
inline constexpr std::size_t longest_suggested = 100;

/// Edits from one name to the other: a letter put in, left out or replaced, or two neighbours exchanged, each
/// counted once (optimal string alignment). Upper and lower case of ASCII letters are alike. Where a name has
/// more than longest_suggested bytes, the length of the longer one, as if no letter were the same. For "did you
/// mean".
std::size_t edit_distance(std::string_view a, std::string_view b);

/// "; did you mean NAME?" with the name that the user most likely meant: a name that begins with `typed`, or
/// the name of the smallest edit distance, if that is at most a third of the letters of `typed` (or 1). Empty
/// where there is no such name. For the end of a message.
std::string did_you_mean(std::string_view typed, const std::vector<std::string>& names);

}  // namespace etak
