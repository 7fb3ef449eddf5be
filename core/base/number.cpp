// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace etak {

bool parse_number(std::string_view text, double& value) {
  // from_chars takes no plus sign. It is removed here, unless a second sign is behind it.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

void append_number(std::string& out, double value, int digits) {
  std::array<char, 64> text;
  const auto result =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  out.append(text.data(), result.ptr);
}

std::string number(double value, int digits) {
  std::string out;
  append_number(out, value, digits);
  return out;
}

}  // namespace etak
