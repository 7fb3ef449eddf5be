// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace etak {

inline void append_part(std::string& out, std::string_view text) {
  out += text;
}
inline void append_part(std::string& out, char c) {
  out += c;
}

/// Appends every part in turn: strings, literals and single characters.
template <class... Parts>
void append(std::string& out, const Parts&... parts) {
  (append_part(out, parts), ...);
}

/// `text` with every byte that is not part of well-formed UTF-8 (RFC 3629) replaced by U+FFFD: file names may
/// hold anything, JSON and HTML may not.
std::string valid_utf8(std::string_view text);

/// Columns a terminal gives to UTF-8 text: one per code point, none for combining marks, two for East Asian
/// wide ones (told apart by block, which is good enough for names).
std::size_t display_width(std::string_view text);

/// `text` with the five characters that mean something in HTML and XML escaped, and made valid UTF-8.
std::string escape_html(std::string_view text);

/// `value` with a fixed number of decimals, at most 30; never "-0"; from 1e15 on as number(value, 6).
std::string fixed(double value, int decimals);

}  // namespace etak
