// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"

#include <algorithm>
#include <cstring>

#include "core/base/text/text.h"

namespace etak {

Error Error::at(std::string_view place, std::string_view found, std::string_view expected) {
  std::string text(place);
  text.append(": ").append(found);
  if (!expected.empty()) text.append("; expected ").append(expected);
  return Error(text);
}

Error Error::at_line(std::string_view file, std::size_t line, std::string_view found,
                     std::string_view expected) {
  return at(std::string(file) + ":" + std::to_string(line), found, expected);
}

std::string reason_of(int error_number) {
  return std::strerror(error_number);
}

std::string printable(std::string_view bytes, std::size_t most) {
  std::size_t end = std::min(most, bytes.size());
  // A character that begins before the end stays whole.
  while (end > 0 && end < bytes.size() && end < most + 3 &&
         (static_cast<unsigned char>(bytes[end]) & 0xC0) == 0x80)
    ++end;
  return line_text(bytes.substr(0, end)) + (end < bytes.size() ? "..." : "");
}

std::string in_quotes(std::string_view bytes, std::size_t most) {
  return '"' + printable(bytes, most) + '"';
}

}  // namespace etak
