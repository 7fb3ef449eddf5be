// SPDX-License-Identifier: Apache-2.0
// The tokens of the formula texts, for the functions that pick, prune and translate them.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/text/ascii.h"

namespace etak {

inline bool is_word(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

/// The end of the token that begins at `at`: a comment up to the end of its line, a word, a number, or one
/// character.
inline std::size_t token_end(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  const auto here = [&](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
  if (text[at] == '/' && here(at + 1) == '/') {
    while (end < text.size() && text[end] != '\n') ++end;
  } else if (is_digit(text[at]) || (text[at] == '.' && is_digit(here(at + 1)))) {
    while (is_word(here(end)) || here(end) == '.' ||
           ((here(end) == '-' || here(end) == '+') && (here(end - 1) == 'e' || here(end - 1) == 'E')))
      ++end;
  } else if (is_word(text[at])) {
    while (is_word(here(end))) ++end;
  }
  return end;
}

template <class Visit>
void for_each_token(std::string_view text, Visit visit) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = token_end(text, at);
    visit(text.substr(at, end - at), text.substr(end));
    at = end;
  }
}

inline bool is_comment(std::string_view token) {
  return token.starts_with("//");
}

}  // namespace etak
