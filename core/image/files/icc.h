// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace etak {

/// The largest colour profile that is looked at; those of screens and working spaces have 0.4 to 60 KB.
inline constexpr std::size_t largest_profile_bytes = std::size_t{1} << 20;

/// What an ICC profile says of a picture's codes.
///   curve       "srgb", "linear", "gamma22", "gamma 0.55556" (the exponent that encodes) or "a curve of its
///               own"
///   primaries   "sRGB", "Display P3", "Adobe RGB", "Rec. 2020", "ProPhoto RGB" or "others"; "greys" of a
///               profile of greys
struct IccColors {
  std::string curve, primaries;
  friend bool operator==(const IccColors&, const IccColors&) = default;
};

/// Reads the curves and primaries of an RGB profile, or the curve of a grey one (ICC.1:2010, "curveType",
/// "parametricCurveType", "XYZType"). A curve is one of those above when it never differs by more than 2 of
/// 255 sRGB codes from it, and primaries when no coordinate of their XYZ under D50 differs by more than 0.01.
/// nullopt: broken, of tables in place of curves, of another colour model, or too large.
std::optional<IccColors> icc_colors(std::string_view profile);

/// "linear", "gamma22" (1/2.2, which countless sRGB files name as the nearest power) or "gamma 0.6".
///   exponent   that encodes
std::string power_curve_name(double exponent);

}  // namespace etak
