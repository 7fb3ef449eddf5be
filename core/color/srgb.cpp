// SPDX-License-Identifier: Apache-2.0
#include "core/color/srgb.h"

#include <algorithm>
#include <cmath>

#include "core/base/bytes/hex.h"
#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/math/functions.h"

namespace etak {
double srgb_encode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * math::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : math::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t plain_u8(double value) {
  return static_cast<std::uint8_t>(std::floor(255 * std::clamp(value, 0.0, 1.0) + 0.5));
}

std::uint8_t srgb_u8(double linear) {
  return plain_u8(srgb_encode(std::clamp(linear, 0.0, 1.0)));
}

std::uint8_t power22_u8(double linear) {
  return plain_u8(math::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2));
}

Srgb8 srgb_u8(const LinearRgb& c) {
  return {srgb_u8(c.r), srgb_u8(c.g), srgb_u8(c.b)};
}

Srgb8 power22_u8(const LinearRgb& c) {
  return {power22_u8(c.r), power22_u8(c.g), power22_u8(c.b)};
}

LinearRgb srgb_decode(const Srgb8& codes) {
  return {srgb_decode(codes.r / 255.0), srgb_decode(codes.g / 255.0), srgb_decode(codes.b / 255.0)};
}

std::string hex(const Srgb8& codes) {
  std::string out = "#";
  for (const std::uint8_t code : {codes.r, codes.g, codes.b}) append_hex(out, static_cast<char>(code));
  return out;
}

Srgb8 parse_hex(std::string_view text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '#') digits.remove_prefix(1);
  const bool is_hex = std::all_of(digits.begin(), digits.end(), [](char c) { return hex_digit(c) >= 0; });
  if (!is_hex || (digits.size() != 3 && digits.size() != 6))
    throw Error::at("colour " + in_quotes(text), "no hexadecimal colour", "#rrggbb or #rgb");
  const std::size_t width = digits.size() / 3;
  const auto code = [&](std::size_t channel) {
    const int high = hex_digit(digits[channel * width]), low = hex_digit(digits[channel * width + width - 1]);
    return static_cast<std::uint8_t>(16 * high + low);
  };
  return {code(0), code(1), code(2)};
}

}  // namespace etak
