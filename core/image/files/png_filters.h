// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace etak {

/// Bytes behind a row that must be readable (input rows) or writable (output rows), because the loops work on
/// whole registers.
inline constexpr std::size_t png_row_slack = 64;
/// Bytes in front of a row to be filtered. They must be 0, the value that PNG gives to the left of the first
/// pixel.
inline constexpr std::size_t png_row_lead = 16;

/// The row filters of PNG (ISO/IEC 15948, 9.2) for one instruction set: 0 None, 1 Sub, 2 Up, 3 Average, 4
/// Paeth. All instruction sets give the same bytes.
struct PngFilters {
  const char* instructions;

  /// Filters a row by the filter whose differences, as signed bytes, have the least sum of absolute values;
  /// among equal sums the filter of the lowest number is taken.
  ///   row, above   `size` bytes each, with png_row_lead zeros in front and png_row_slack bytes behind
  ///   pixel        bytes of a pixel, 1..8
  ///   out          room for the number of the filter and `size` bytes, with png_row_slack bytes behind
  void (*filter)(const std::uint8_t* row, const std::uint8_t* above, std::size_t size, std::size_t pixel,
                 std::uint8_t* out);

  /// Undoes `filter` (0..4) on a row.
  ///   row     `size` filtered bytes, with png_row_slack bytes behind
  ///   above   the finished row above, or zeros for the first row; nothing behind it is read
  ///   out     room for `size` bytes; nothing behind them is written
  void (*unfilter)(int filter, const std::uint8_t* row, const std::uint8_t* above, std::size_t size,
                   std::size_t pixel, std::uint8_t* out);
};

const PngFilters& png_filters_portable();
#ifdef ETAK_PNG_X86_64
const PngFilters& png_filters_sse2();
const PngFilters& png_filters_avx2();  // only where the processor has AVX2
#endif

/// The fastest filters for the processor that runs the program.
const PngFilters& png_filters();

}  // namespace etak
