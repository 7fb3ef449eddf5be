// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/image/linear_tables.h"

namespace etak::mip_detail {

struct Texel;

/// The inner loops of the 8-bit mip chain for several texels at a time, for rows without special cases. They
/// apply the same operations to each number as the plain loops, so the results are equal bit by bit.
struct MipRows {
  /// Means of 2 x 2 texels from two rows of codes, for both textures, as average_rows() makes them; normals
  /// are not read. Returns how many of the `count` texels were made; the caller makes the others.
  int (*average)(const std::uint8_t* a0, const std::uint8_t* a1, const std::uint8_t* b0,
                 const std::uint8_t* b1, int count, bool weigh_by_opacity, const LinearTables& tables,
                 Texel* a, Texel* b);

  /// Codes of texels of both textures, without normals. Returns how many texels were made, and adds to
  /// `wider` how many of these have 1/e above `widest`.
  int (*encode)(const Texel* a, const Texel* b, int count, const LinearTables& tables, float widest,
                std::uint8_t* out_a, std::uint8_t* out_b, std::size_t& wider);
};

/// The loops for the processor that runs the program; null where there are only the plain loops.
const MipRows* mip_rows();
#ifdef ETAK_MIPS_X86_64
const MipRows& mip_rows_avx2();  // only where the processor has AVX2
#endif

}  // namespace etak::mip_detail
