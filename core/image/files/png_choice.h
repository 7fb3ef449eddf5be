// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image/files/png.h"
#include "core/image/image.h"

namespace etak {

// How a picture is written as PNG where bytes are weighed against time, and in which of PNG's forms.

/// The level at which a picture is compressed once and sent ten times in the least time: bytes at one megabyte
/// a second, compressing at fixed speeds, those of one core. What the picture becomes is told by samples of its
/// rows, at most a megabyte of them. The same picture has the same level on every machine.
PngLevel png_level_for(const PngRows& image);

/// A picture in a form of PNG with fewer bits a texel, which reads as the same channels and codes.
struct PackedPng {
  PictureHeader header;  // its bits: 1, 2, 4 or 8 of one channel
  PngPalette palette;    // empty: grey
  std::vector<std::uint8_t> rows;
  std::size_t stride = 0;

  PngRows view() const { return {header, rows.data(), stride}; }
};

/// Grey of 1, 2 or 4 bits where that holds all codes; RGB and RGBA of up to 256 colours as codes of a palette.
/// nullopt where neither holds the picture. Grey is never made a palette, which readers spread over three
/// channels, nor RGBA whose alpha is full, which they would read as RGB.
std::optional<PackedPng> packed_png(const Image8& image);

/// A PNG file of the fewest bytes: as it is, or packed.
///   options   of both; its palette is not looked at
std::string least_png(const Image8& image, const PngOptions& options);

}  // namespace etak
