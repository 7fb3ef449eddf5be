// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/text/ascii.h"

namespace etak {

/// Cursor over the subset of YAML that the refractiveindex.info database is written in: a mapping at column 0
/// whose values are block scalars (`|`), one-line scalars, or indented blocks; `#` comments; blank lines.
/// Used by the readers of pages; everything that is not of this form is an Error with file and line.
///
/// The cursor stands at the start of a line, except between a key and its value.
class YamlLines {
 public:
  YamlLines(std::string_view text, std::string_view file);

  /// Steps over the next key of the top mapping; the cursor stands behind its colon. False at the end of the
  /// text, and at a list item at column 0 when no key came before (is_list() is true then). A key twice is an
  /// Error.
  bool next_top_key(std::string_view& key);
  bool is_list() const { return is_list_; }

  /// Steps over blank and comment lines; returns the number of spaces the next line starts with, -1 at the
  /// end.
  int next_line();

  /// Steps over `name:` at the cursor.
  std::string_view key();

  /// Steps over the rest of the line and returns it without blanks around and without a comment.
  std::string_view value();

  /// Steps over the lines that belong to a key at column `indent`.
  void skip_block(int indent);

  [[noreturn]] void fail(const char* where, std::string_view found, std::string_view expected = {}) const;

  /// The token at `where`, quoted for a message.
  [[noreturn]] void fail_token(const char* where, std::string_view expected) const;

  const char* at = nullptr;  // the cursor
  const char* const end;

 private:
  static constexpr std::size_t most_keys = 64;

  const char* const begin_;
  const std::string_view file_;
  std::array<std::string_view, most_keys> keys_;
  std::size_t key_count_ = 0;
  bool is_list_ = false;
  bool takes_list_ = false;  // the last key has nothing behind its colon
};

/// What may stand between and behind the numbers of a line: blanks, and the carriage return of a file with
/// Windows' line ends.
constexpr bool is_blank_in_line(char c) {
  return is_blank(c) || c == '\r';
}

/// True for `-` followed by a blank or the end of the line.
bool is_dash(const char* at, const char* end);

/// A scalar without its quotes, if it has any ('' and \" are not undone: names and numbers do not need it).
std::string_view unquoted(std::string_view scalar);

}  // namespace etak
