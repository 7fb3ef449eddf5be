// SPDX-License-Identifier: Apache-2.0
#include "core/rects/text.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/number.h"

namespace etak {
namespace {

std::string_view next_word(std::string_view& rest) {
  const std::size_t begin = rest.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return rest = {};
  const std::size_t end = std::min(rest.find_first_of(" \t\r", begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

}  // namespace

std::vector<RectSize> parse_rects(std::string_view text, std::string_view file) {
  std::vector<RectSize> out;
  std::string_view rest = text;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view words = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::string_view whole = words;
    const std::string_view first = next_word(words);
    if (first.empty() || first.front() == '#') continue;
    const std::optional<int> w = whole_number<int>(first), h = whole_number<int>(next_word(words));
    if (!w || !h || !next_word(words).empty())
      throw Error::at_line(file, line, "'" + printable(whole) + "'", "two whole numbers, width and height");
    if (*w < 1 || *h < 1 || *w > largest_rect_side || *h > largest_rect_side)
      throw Error::at_line(file, line, "'" + printable(whole) + "'",
                           "sides of 1 to " + std::to_string(largest_rect_side));
    out.push_back({*w, *h});
  }
  return out;
}

}  // namespace etak
