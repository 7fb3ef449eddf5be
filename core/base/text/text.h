// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

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

/// The text of every part, none of them empty, with `between` between them.
///   text_of   of a part: a function or a member
template <class Parts, class TextOf = std::identity>
std::string joined(const Parts& parts, std::string_view between = ", ", TextOf text_of = {}) {
  std::string out;
  for (const auto& part : parts)
    append(out, out.empty() ? std::string_view() : between, std::invoke(text_of, part));
  return out;
}

/// The parts of `text` between separators, without empty ones.
std::vector<std::string> parts_of(std::string_view text, char separator);

/// `text` with every byte that is not part of well-formed UTF-8 (RFC 3629) replaced by U+FFFD: file names may
/// hold anything, JSON and HTML may not.
std::string valid_utf8(std::string_view text);

/// `text`, which may come from outside, as a part of one line for a person, a terminal or the log of a build.
/// Characters that would act there instead of being read are shown by their number: bytes that are
/// control characters or no UTF-8 as `\x1b`, control characters above 127, marks that turn the direction of
/// writing and separators of lines as `\u202e`. Build services take a line that begins with `::` and a `##`
/// anywhere for a command, so the first character of a `::` at the beginning or behind a blank of Unicode, and
/// of every `##`, is shown as `\x3a`, `\x23`. All other text stays as it is; the function leaves its own output unchanged.
std::string line_text(std::string_view text);

/// `text`, a JSON document or value, with the characters that line_text() would show by their number written
/// as JSON's own escapes: a reader gets the same strings, and no terminal or log acts on them. Line ends
/// between the values stay.
std::string quiet_json(std::string text);

/// A cell of a text table: line_text() with blanks behind it up to `width` columns.
std::string padded(std::string_view text, std::size_t width);

/// The width in columns of line_text() of `text`, without padding.
std::size_t cell_width(std::string_view text);

/// Columns a terminal gives to UTF-8 text: one per code point, none for combining marks, two for East Asian
/// wide ones (told apart by block, which is good enough for names).
std::size_t display_width(std::string_view text);

/// The longest front of `text`, of whole characters, that is at most `columns` wide. Takes time for what it
/// returns and not for what is behind it.
std::string_view front_of(std::string_view text, std::size_t columns);

/// `text` for HTML, SVG and other XML, in content or a quoted attribute: the five characters that mean
/// something there are escaped, line ends and tabs become blanks, and the rest is as line_text() has it.
std::string escape_html(std::string_view text);

/// `value` with a fixed number of decimals, at most 30; never "-0"; from 1e15 on as number(value, 6).
std::string fixed(double value, int decimals);

}  // namespace etak
