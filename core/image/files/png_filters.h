// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace etak {

/// Bytes that must be readable (rows that come in) or writable (rows that go out) behind a row: the loops
/// work on whole registers.
inline constexpr std::size_t png_row_slack = 64;
/// Bytes before a row to be filtered, all 0: what stands left of the first pixel.
inline constexpr std::size_t png_row_lead = 16;

/// The row filters of PNG (ISO/IEC 15948, 9.2): 0 None, 1 Sub, 2 Up, 3 Average, 4 Paeth, with one kind of
/// instruction. All kinds give the same bytes.
struct PngFilters {
  const char* instructions;

  /// Filters a row by the one of the five filters whose differences, as signed bytes, have the least sum of
  /// absolute values (of equals the first).
  ///   row, above   `size` bytes each, with png_row_lead zeros before and png_row_slack behind
  ///   pixel        bytes of a pixel, 1..8
  ///   out          the filter's number and `size` bytes, png_row_slack behind
  void (*filter)(const std::uint8_t* row, const std::uint8_t* above, std::size_t size, std::size_t pixel,
                 std::uint8_t* out);

  /// The row that `filter` (0..4) made.
  ///   row     `size` filtered bytes, png_row_slack behind
  ///   above   the finished row above, or zeros; nothing behind it is read
  ///   out     `size` bytes; nothing behind them is written
  void (*unfilter)(int filter, const std::uint8_t* row, const std::uint8_t* above, std::size_t size,
                   std::size_t pixel, std::uint8_t* out);
};

const PngFilters& png_filters_portable();
#ifdef ETAK_PNG_X86_64
const PngFilters& png_filters_sse2();
const PngFilters& png_filters_avx2();  // only where the processor has AVX2
#endif

/// The fastest kind for this processor.
const PngFilters& png_filters();

}  // namespace etak
