// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace etak {

// Letters, digits and blanks of ASCII, whatever the locale: other bytes are none of them and stay as they
// are.

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
constexpr bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
constexpr bool is_letter(char c) {
  return is_lower(c) || is_upper(c);
}
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
constexpr bool is_space(char c) {
  return is_blank(c) || is_line_end(c);
}

constexpr char lower_case(char c) {
  return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}
inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lower_case(c);
  return out;
}

/// What a hexadecimal digit of either case stands for; -1 for other characters.
constexpr int hex_digit(char c) {
  const char low = lower_case(c);
  return is_digit(c) ? c - '0' : low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
}

/// `text` without the characters of `blanks` at both ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view blanks = " \t") {
  const auto first = text.find_first_not_of(blanks);
  return first == text.npos ? text.substr(0, 0)
                            : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// An id out of a name: "My sample (2)" as "my_sample_2". Letters in lower case and digits; one `separator`
/// for what is between them, none at the ends. Empty where `text` has neither.
inline std::string identifier(std::string_view text, char separator) {
  std::string out;
  for (const char c : text)
    if (is_letter(c) || is_digit(c))
      out += lower_case(c);
    else if (!out.empty() && out.back() != separator)
      out += separator;
  if (!out.empty() && out.back() == separator) out.pop_back();
  return out;
}

}  // namespace etak
