// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/code_tables.h"

#include <algorithm>
#include <cmath>

#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/math/functions.h"

namespace etak {

double decode_of(TextureTransfer transfer, double encoded) {
  switch (transfer) {
    case TextureTransfer::srgb:
      return srgb_decode(encoded);
    case TextureTransfer::power_22:
      return math::pow(encoded, 2.2);
    case TextureTransfer::linear:
      return encoded;
  }
  return encoded;
}

double encode_of(TextureTransfer transfer, double linear) {
  switch (transfer) {
    case TextureTransfer::srgb:
      return srgb_encode(linear);
    case TextureTransfer::power_22:
      return math::pow(linear, 1 / 2.2);
    case TextureTransfer::linear:
      return linear;
  }
  return linear;
}

namespace {

std::uint32_t fixed(double value) {
  return static_cast<std::uint32_t>(std::floor(value * linear_one + 0.5));
}

}  // namespace

CodeTables::CodeTables(TextureTransfer transfer) : transfer_(transfer) {
  for (std::size_t code = 0; code < 256; ++code) {
    decoded[code] = decode_of(transfer, static_cast<double>(code) / 255);
    linear[code] = fixed(decoded[code]);
    red[code] = fixed(luminance_weights<double>[0] * decoded[code]);
    green[code] = fixed(luminance_weights<double>[1] * decoded[code]);
    blue[code] = fixed(luminance_weights<double>[2] * decoded[code]);
    // A limit lies half a code below its code, so that a grey has its own code as luminance code in spite of
    // rounding.
    code_first_[code] = code == 0 ? 0 : fixed(decode_of(transfer, (static_cast<double>(code) - 0.5) / 255));
  }
  for (std::size_t i = 0; i < code_start_.size(); ++i) {
    const auto y = static_cast<std::uint32_t>(i << code_shift);
    const auto after = std::upper_bound(code_first_.begin(), code_first_.end(), y);
    code_start_[i] = static_cast<std::uint8_t>(after - code_first_.begin() - 1);
  }
}

int CodeTables::first_code_at_least(std::uint32_t y) const {
  int code = 0;
  for (; code < 256; ++code) {
    const auto c = static_cast<std::uint8_t>(code);
    if (red[c] + green[c] + blue[c] >= y) break;
  }
  return code;
}

std::uint8_t CodeTables::encode(double value) const {
  const double clamped = std::isnan(value) ? 0 : std::clamp(value, 0.0, 1.0);
  return plain_u8(encode_of(transfer_, clamped));
}

double CodeTables::decode(double code) const {
  return decode_of(transfer_, code / 255);
}

double CodeTables::moved(double limit, double codes) const {
  return limit <= 0 || limit >= 1 ? limit : decode(255 * encode_of(transfer_, limit) + codes);
}

std::uint32_t first_above(double limit) {
  return static_cast<std::uint32_t>(std::floor(limit * linear_one)) + 1;
}

std::uint32_t first_at_least(double limit) {
  return static_cast<std::uint32_t>(std::ceil(limit * linear_one));
}

const std::array<bool, 101>& comb_codes() {
  static const auto comb = [] {
    std::array<bool, 101> has{};
    for (int i = 0; i < 256; ++i)
      if (const int code = code_tables(TextureTransfer::srgb).encode(i / 255.0); code <= 100)
        has[static_cast<std::size_t>(code)] = true;
    return has;
  }();
  return comb;
}

const CodeTables& code_tables(TextureTransfer transfer) {
  static const CodeTables srgb(TextureTransfer::srgb), power_22(TextureTransfer::power_22),
      linear(TextureTransfer::linear);
  return transfer == TextureTransfer::srgb ? srgb : transfer == TextureTransfer::power_22 ? power_22 : linear;
}

}  // namespace etak
