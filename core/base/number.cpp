// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/error.h"

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

std::string grouped(std::uint64_t value) {
  std::string out = std::to_string(value);
  for (std::size_t at = out.size(); at > 3;) out.insert(at -= 3, 1, ',');
  return out;
}

std::size_t byte_size(std::string_view text, std::string_view option) {
  const char unit = text.empty() ? ' ' : text.back();
  const int shift = unit == 'K' ? 10 : unit == 'M' ? 20 : unit == 'G' ? 30 : 0;
  constexpr double most = 1e18;
  double value = 0;
  const bool good = parse_number(shift == 0 ? text : text.substr(0, text.size() - 1), value);
  value *= static_cast<double>(std::size_t{1} << shift);
  if (!good || value < 1 || value > most)
    throw Error::at(option, printable(text), "a number of bytes, with K, M or G for more");
  // Less than `most` where addresses have 32 bits: there is no more memory then.
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  return value < static_cast<double>(all) ? static_cast<std::size_t>(value) : all;
}

}  // namespace etak
