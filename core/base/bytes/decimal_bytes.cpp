// SPDX-License-Identifier: Apache-2.0
#include "core/base/bytes/decimal_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "core/base/bytes/bytes_le.h"

namespace etak {
namespace {

// A mantissa below 2^53 times or over a power of ten up to 10^22 is the double nearest to the decimal number, because
// both are exact as doubles and the processor rounds once.
constexpr std::int64_t most_mantissa = std::int64_t{1} << 53;
constexpr int most_exponent = 22;
constexpr std::array<double, most_exponent + 1> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                       1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                       1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// The first byte: how often differences were taken, or one of these.
constexpr std::uint8_t most_differences = 2, own_exponents = 3, doubles = 4;

struct Decimal {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

bool in_range(std::int64_t exponent) {
  return -most_exponent <= exponent && exponent <= most_exponent;
}

double value_of(std::int64_t mantissa, int exponent) {
  const auto number = static_cast<double>(mantissa);
  const double power = powers[static_cast<std::size_t>(std::abs(exponent))];
  return exponent < 0 ? number / power : number * power;
}

// The decimal number with the fewest digits that reads back as the value; none where it is beyond the bounds.
std::optional<Decimal> decimal_of(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  std::array<char, 32> text{};
  char* const end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific).ptr;
  char* const e = std::find(text.data(), end, 'e');
  Decimal out;
  std::from_chars(e + (e[1] == '+' ? 2 : 1), end, out.exponent);
  char* const point = std::find(text.data(), e, '.');
  out.exponent -= point == e ? 0 : static_cast<int>(e - point) - 1;
  std::from_chars(text.data(), std::remove(text.data(), e, '.'), out.mantissa);
  if (out.mantissa == 0) out.exponent = 0;
  for (; out.mantissa != 0 && out.mantissa % 10 == 0; out.mantissa /= 10) ++out.exponent;
  if (std::abs(out.mantissa) >= most_mantissa || !in_range(out.exponent)) return std::nullopt;
  if (std::bit_cast<std::uint64_t>(value_of(out.mantissa, out.exponent)) !=
      std::bit_cast<std::uint64_t>(value))
    return std::nullopt;
  return out;
}

// Seven bits a byte, the lowest first, with the sign in the lowest bit.
void append_number(std::string& out, std::int64_t value) {
  auto rest = static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
  for (; rest >= 128; rest >>= 7) out += static_cast<char>(rest | 128);
  out += static_cast<char>(rest);
}

bool read_number(std::string_view bytes, std::size_t& at, std::int64_t& value) {
  std::uint64_t read = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (at == bytes.size()) return false;
    const auto byte = static_cast<std::uint8_t>(bytes[at++]);
    read |= std::uint64_t{byte & 127U} << shift;
    if (byte >= 128) continue;
    value = static_cast<std::int64_t>(read >> 1 ^ (0 - (read & 1)));
    return true;
  }
  return false;
}

// All numbers as multiples of the power of ten of the one with the most places, if none becomes too large.
std::optional<std::vector<std::int64_t>> on_one_exponent(const std::vector<Decimal>& numbers, int exponent) {
  std::vector<std::int64_t> out;
  out.reserve(numbers.size());
  for (Decimal each : numbers) {
    if (each.mantissa == 0) each.exponent = exponent;
    for (; each.exponent > exponent; --each.exponent) {
      each.mantissa *= 10;
      if (std::abs(each.mantissa) >= most_mantissa) return std::nullopt;
    }
    out.push_back(each.mantissa);
  }
  return out;
}

std::string with_own_exponents(const std::vector<Decimal>& numbers) {
  std::string out(1, static_cast<char>(own_exponents));
  for (const Decimal& each : numbers) append_number(out, each.exponent);
  for (const Decimal& each : numbers) append_number(out, each.mantissa);
  return out;
}

std::string as_doubles(const std::vector<double>& values) {
  std::string out(1, static_cast<char>(doubles));
  for (const double value : values) bytes_le::append64(out, std::bit_cast<std::uint64_t>(value));
  return out;
}

std::string as_decimals(const std::vector<Decimal>& numbers) {
  std::string best = with_own_exponents(numbers);
  int exponent = most_exponent;
  for (const Decimal& each : numbers)
    if (each.mantissa != 0) exponent = std::min(exponent, each.exponent);
  auto steps = on_one_exponent(numbers, exponent);
  for (std::uint8_t differences = 0; steps && differences <= most_differences; ++differences) {
    std::string form(1, static_cast<char>(differences));
    append_number(form, exponent);
    for (const std::int64_t step : *steps) append_number(form, step);
    if (form.size() < best.size()) best = std::move(form);
    for (std::size_t i = steps->size(); i-- > 1;) (*steps)[i] -= (*steps)[i - 1];
  }
  return best;
}

bool read_doubles(std::string_view bytes, std::vector<double>& out) {
  constexpr std::size_t size = 8;
  if (bytes.size() != 1 + out.size() * size) return false;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::bit_cast<double>(bytes_le::number64(bytes, 1 + i * size));
  return true;
}

bool read_own_exponents(std::string_view bytes, std::size_t at, std::vector<double>& out) {
  std::vector<int> exponents(out.size());
  std::int64_t read = 0;
  for (int& exponent : exponents) {
    if (!read_number(bytes, at, read) || !in_range(read)) return false;
    exponent = static_cast<int>(read);
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!read_number(bytes, at, read)) return false;
    out[i] = value_of(read, exponents[i]);
  }
  return at == bytes.size();
}

// Sums wrap round where the bytes are no differences that decimal_bytes() wrote.
bool read_steps(std::string_view bytes, std::size_t at, std::uint8_t differences, std::vector<double>& out) {
  std::int64_t exponent = 0, read = 0;
  if (!read_number(bytes, at, exponent) || !in_range(exponent)) return false;
  std::uint64_t value = 0, step = 0;
  for (double& each : out) {
    if (!read_number(bytes, at, read)) return false;
    step = differences == 2 ? step + static_cast<std::uint64_t>(read) : static_cast<std::uint64_t>(read);
    value = differences == 0 ? step : value + step;
    each = value_of(static_cast<std::int64_t>(value), static_cast<int>(exponent));
  }
  return at == bytes.size();
}

}  // namespace

std::string decimal_bytes(const std::vector<double>& values) {
  std::vector<Decimal> numbers;
  for (const double value : values)
    if (const auto decimal = decimal_of(value))
      numbers.push_back(*decimal);
    else
      break;
  std::string form = as_doubles(values);
  if (numbers.size() == values.size())
    if (std::string decimals = as_decimals(numbers); decimals.size() < form.size())
      form = std::move(decimals);
  std::string out;
  bytes_le::append32(out, values.size());
  return out + form;
}

bool read_decimal_bytes(std::string_view bytes, std::vector<double>& out) {
  constexpr std::size_t size = 4;
  if (bytes.size() <= size) return false;
  const std::size_t count = bytes_le::number32(bytes, 0);
  bytes.remove_prefix(size);
  // Each number takes at least a byte, so that the room for them is never more than eight times the bytes.
  if (count >= bytes.size()) return false;
  out.resize(count);
  const auto form = static_cast<std::uint8_t>(bytes.front());
  if (form == doubles) return read_doubles(bytes, out);
  if (form == own_exponents) return read_own_exponents(bytes, 1, out);
  return form <= most_differences && read_steps(bytes, 1, form, out);
}

}  // namespace etak
