// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/color/rgb.h"

namespace etak {

/// The piecewise sRGB curve of IEC 61966-2-1, linear to encoded and back; below zero
/// the curve is not mirrored: negative input is taken by its linear part.
double srgb_encode(double linear);
double srgb_decode(double encoded);

/// floor(255 clamp(value, 0, 1) + 1/2): the code of what is kept as it is, such as opacity and gloss. NaN is
/// the caller's mistake, here and below.
std::uint8_t plain_u8(double value);

/// floor(255 encode(clamp(linear, 0, 1)) + 1/2).
std::uint8_t srgb_u8(double linear);

/// The code by encode(x) = x^(1/2.2), as in Schueler's table.
std::uint8_t power22_u8(double linear);

Srgb8 srgb_u8(const LinearRgb& linear);
Srgb8 power22_u8(const LinearRgb& linear);
LinearRgb srgb_decode(const Srgb8& codes);

/// "#rrggbb", lower case.
std::string hex(const Srgb8& codes);

/// Reads "#rrggbb", "rrggbb" or "#rgb". Throws Error.
Srgb8 parse_hex(std::string_view text);

}  // namespace etak
