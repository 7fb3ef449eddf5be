// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"

#include <array>

namespace etak {
namespace {

// Length of the UTF-8 sequence that starts at text[i], or 0 where the bytes are no valid sequence.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  const std::size_t length = byte < 0x80                   ? 1
                             : byte >= 0xC2 && byte < 0xE0 ? 2
                             : byte >= 0xE0 && byte < 0xF0 ? 3
                             : byte >= 0xF0 && byte < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || i + length > text.size()) return 0;
  for (std::size_t j = 1; j < length; ++j)
    if ((static_cast<unsigned char>(text[i + j]) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates and what lies above U+10FFFF show in the second byte.
  const unsigned char second = length > 1 ? static_cast<unsigned char>(text[i + 1]) : 0;
  if ((byte == 0xE0 && second < 0xA0) || (byte == 0xED && second > 0x9F) || (byte == 0xF0 && second < 0x90) ||
      (byte == 0xF4 && second > 0x8F))
    return 0;
  return length;
}

}  // namespace

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

std::string printable(std::string_view bytes, std::size_t most) {
  static constexpr std::array<char, 17> hex{"0123456789abcdef"};
  std::string out;
  for (std::size_t i = 0; i < bytes.size();) {
    if (i >= most) return out + "...";
    const std::size_t length = utf8_length(bytes, i);
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (length == 0 || byte < 0x20 || byte == 0x7F) {
      out.append("\\x").push_back(hex[byte >> 4]);
      out.push_back(hex[byte & 15]);
      ++i;
    } else {
      out.append(bytes.substr(i, length));
      i += length;
    }
  }
  return out;
}

}  // namespace etak
