// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace etak {

/// The whole of `text` as a finite decimal number ("1.5", "-2e-3", "+3"); false for anything else, NaN and
/// infinity included. Locale plays no part.
bool parse_number(std::string_view text, double& value);

/// The whole of `text` as a whole number in decimal digits; none for anything else, and for one that `Value`
/// cannot hold.
template <class Value>
std::optional<Value> whole_number(std::string_view text) {
  Value value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Appends `value` with at most `digits` significant digits, as printf's %.{digits}g in the C locale.
void append_number(std::string& out, double value, int digits);

/// The text that append_number() appends.
std::string number(double value, int digits);

/// A whole number with commas between thousands: "2,914".
std::string grouped(std::uint64_t value);

/// The bytes that "4096", "64K", "512M" or "2G" stand for. Throws Error that names the option.
std::size_t byte_size(std::string_view text, std::string_view option);

}  // namespace etak
