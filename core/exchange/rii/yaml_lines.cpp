// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rii/yaml_lines.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/text/ascii.h"

namespace etak {
namespace {

bool is_key_char(char c) {
  return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.';
}

const char* next_line_start(const char* at, const char* end) {
  const std::string_view rest(at, static_cast<std::size_t>(end - at));
  const std::size_t newline = rest.find('\n');
  return newline == rest.npos ? end : at + newline + 1;
}

}  // namespace

bool is_dash(const char* at, const char* end) {
  return at < end && *at == '-' && (at + 1 == end || is_blank(at[1]) || is_line_end(at[1]));
}

std::string_view unquoted(std::string_view scalar) {
  if (scalar.size() >= 2 && (scalar.front() == '"' || scalar.front() == '\'') &&
      scalar.back() == scalar.front())
    return scalar.substr(1, scalar.size() - 2);
  return scalar;
}

YamlLines::YamlLines(std::string_view text, std::string_view file)
    : at(text.data()), end(text.data() + text.size()), begin_(text.data()), file_(file) {
  if (text.empty()) throw Error::at(file, "the file is empty");
  if (text.starts_with("\xEF\xBB\xBF")) at += 3;
}

void YamlLines::fail(const char* where, std::string_view found, std::string_view expected) const {
  const auto line = 1 + static_cast<std::size_t>(std::count(begin_, where, '\n'));
  throw Error::at_line(file_, line, found, expected);
}

void YamlLines::fail_token(const char* where, std::string_view expected) const {
  const char* stop = where;
  while (stop < end && !is_blank(*stop) && !is_line_end(*stop)) ++stop;
  const std::string_view token(where, static_cast<std::size_t>(stop - where));
  fail(where, token.empty() ? "the end of the line" : in_quotes(token), expected);
}

int YamlLines::next_line() {
  while (at < end) {
    const char* first = at;
    while (first < end && *first == ' ') ++first;
    const char* text = first;
    while (text < end && is_blank_in_line(*text)) ++text;
    if (text < end && *text != '\n' && *text != '#') {
      if (text != first) fail(at, "a tab before the first word of the line", "spaces");
      return static_cast<int>(first - at);
    }
    at = next_line_start(text, end);
  }
  return -1;
}

bool YamlLines::next_top_key(std::string_view& name) {
  for (;;) {
    const int indent = next_line();
    if (indent < 0) return false;
    if (indent > 0) fail(at, "an indented line that belongs to no key", "a key at the start of the line");
    if (is_dash(at, end)) {
      is_list_ = key_count_ == 0;
      if (is_list_) return false;
      // YAML lets the list below a key stand at the key's own column.
      if (!takes_list_) fail(at, "a list item at the start of the line", "a key");
      at = next_line_start(at, end);
      skip_block(0);
      continue;
    }
    if (key_count_ == 0 && std::string_view(at, end).starts_with("---")) {
      at = next_line_start(at, end);  // the start of a YAML document
      continue;
    }
    const char* where = at;
    name = key();
    const auto known = keys_.begin() + static_cast<std::ptrdiff_t>(key_count_);
    if (std::find(keys_.begin(), known, name) != known) fail(where, std::string(name) + " twice");
    if (key_count_ == most_keys) fail(where, "more than 64 keys", "a page");
    keys_[key_count_++] = name;
    const char* behind = at;
    takes_list_ = value().empty();
    at = behind;
    return true;
  }
}

std::string_view YamlLines::key() {
  const char* first = at;
  while (at < end && is_key_char(*at)) ++at;
  const bool named =
      at > first && at < end && *at == ':' && (at + 1 == end || is_blank(at[1]) || is_line_end(at[1]));
  if (!named) fail_token(first, "\"key:\"");
  ++at;
  return {first, static_cast<std::size_t>(at - 1 - first)};
}

std::string_view YamlLines::value() {
  while (at < end && is_blank(*at)) ++at;
  const char* first = at;
  at = next_line_start(at, end);
  const char* last = at;
  while (last > first && (is_blank(last[-1]) || is_line_end(last[-1]))) --last;
  const std::string_view line(first, static_cast<std::size_t>(last - first));
  if (line.starts_with('#')) return {};
  // Inside quotes a '#' is text; outside it starts a comment when a blank stands before it.
  if (line.starts_with('"') || line.starts_with('\'')) return line;
  for (std::size_t hash = line.find('#'); hash != line.npos; hash = line.find('#', hash + 1)) {
    if (!is_blank(line[hash - 1])) continue;
    const std::size_t stop = line.find_last_not_of(" \t", hash - 1);
    return line.substr(0, stop + 1);
  }
  return line;
}

void YamlLines::skip_block(int indent) {
  const char* line = at;
  while (line < end) {
    const char* first = line;
    while (first < end && *first == ' ') ++first;
    if (first - line <= indent) {
      const char* text = first;
      while (text < end && is_blank_in_line(*text)) ++text;
      if (text < end && *text != '\n') break;
      first = text;
    }
    line = next_line_start(first, end);
  }
  at = line;
}

}  // namespace etak
