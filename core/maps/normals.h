// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace etak {

// What the texels of a tangent-space normal map come to. A code c stands for 2 c / 255 - 1 (glTF 2.0, 3.9.3),
// so that 0 lies between codes 127 and 128, and no texel can be quite flat.

/// Length from which a normal may differ from 1. Rounding to 8 bits alone makes 0.007; averaging two normals
/// 36 degrees apart, as mips and filters do, 0.05.
inline constexpr double normal_tolerance = 0.05;
/// The least code of blue that may be a rounded z of 0; below it, the normal points into the surface.
inline constexpr std::uint8_t least_upward_code = 127;

/// Exact counts over texels, the same for any order of the rows.
struct NormalFacts {
  std::uint64_t texels = 0;
  std::array<std::uint8_t, 3> least{255, 255, 255}, most{};
  // Further than the tolerance from length 1: as they are; were the codes decoded from sRGB first; were they
  // encoded to sRGB first.
  std::uint64_t not_unit = 0, not_unit_decoded = 0, not_unit_encoded = 0;
  std::uint64_t below = 0;    // z below 0
  std::uint64_t outside = 0;  // x and y alone are longer than 1 and the tolerance
  // Texels of the flattest codes, x and y 127 or 128 and z 254 or 255: by x and by y, those of 127 and 128.
  std::uint64_t flat = 0;
  std::array<std::array<std::uint64_t, 2>, 2> flat_codes{};
  std::uint64_t nearly_flat = 0;           // a code further from flat than these, on one axis or both
  std::array<std::int64_t, 3> sum{};       // of 2 c - 255
  std::int64_t shortest = 0, longest = 0;  // squared lengths, of 255 * 255; 0 where there are no texels

  void add(const NormalFacts& other);
  /// Mean of a component (0 to 2: x, y, z), -1 to 1.
  double mean(std::size_t component) const;
  friend bool operator==(const NormalFacts&, const NormalFacts&) = default;
};

/// Adds a row of `width` texels, 4 bytes each, of which the first three count.
void add_normals(NormalFacts& facts, const std::uint8_t* rgba, int width);

/// How the codes of a map came about.
///   as_is         as a normal map is stored
///   two_channels  blue is 0 all over, or 255 where that is too long: z is left to the shader
///   encoded       linear values were encoded to sRGB: flat is code 188
///   decoded       the codes were taken for sRGB and decoded: flat is code 55
///   unclear       none of these: no normal map, or a broken one
enum class NormalCodes { as_is, two_channels, encoded, decoded, unclear };

/// As they are when no more than a tenth of the texels have another length than 1. Encoded or decoded when
/// more than half of them have, and undoing it leaves no more than a tenth, or lets a mean normal stand up
/// that leans along both axes; a map of one colour is judged too. Nothing for no texels.
std::optional<NormalCodes> normal_codes(const NormalFacts& facts);

/// Whether every texel has the same three codes: a texture that a number could stand for.
bool is_constant(const NormalFacts& facts);

/// Whether flat areas have code 127 in some places and 128 in others, on one axis: each on at least a
/// hundredth of the flat texels, and these on a tenth of the map. The two differ by 0.45 degrees, which shows
/// as an edge in mirrors. A gentle relief is no such map: it runs through the codes beside these two as well, so that
/// more than half as many texels are nearly flat.
bool is_flat_in_two_codes(const NormalFacts& facts);

}  // namespace etak
