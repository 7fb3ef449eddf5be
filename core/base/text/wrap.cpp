// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/wrap.h"

#include <algorithm>

#include "core/base/text/text.h"

namespace etak {

std::string wrapped(std::string_view text, std::size_t indent, std::size_t columns) {
  std::string out, line;
  const auto flush = [&] {
    if (!line.empty()) out += std::string(indent, ' ') + line + '\n';
    line.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    const bool full = columns > 0 && indent + display_width(line) + 1 + display_width(word) > columns;
    if (!line.empty() && full) flush();
    if (!word.empty()) line += (line.empty() ? "" : " ") + std::string(word);
    if (end < text.size() && text[end] == '\n') flush();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  flush();
  return out;
}

}  // namespace etak
