// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace etak {

/// Size of the largest colour profile that is read, in bytes. Profiles of screens and working spaces have 0.4
/// to 60 KB.
inline constexpr std::size_t largest_profile_bytes = std::size_t{1} << 20;

/// What an ICC profile says about the codes of a picture.
///   curve       "srgb", "linear", "power-2.2", "gamma 0.55556" (the exponent that encodes) or "a curve of its
///               own"
///   primaries   "sRGB", "Display P3", "Adobe RGB", "Rec. 2020", "ProPhoto RGB" or "others"; "greys" for a
///               grey profile
struct IccColors {
  std::string curve, primaries;
  friend bool operator==(const IccColors&, const IccColors&) = default;
};

/// Reads the curves and primaries of an RGB profile, or the curve of a grey one (ICC.1:2010, "curveType",
/// "parametricCurveType", "XYZType"). A curve gets the name of a known one when it differs from it by at most
/// 2 of 255 sRGB codes everywhere; primaries get a name when no coordinate of their XYZ under D50 differs by
/// more than 0.01.
///   returns   nullopt for profiles that are broken, that have tables in place of curves, that are of another
///             colour model, or that are too large
std::optional<IccColors> icc_colors(std::string_view profile);

/// The name of primaries, as IccColors has them, by x and y of red, green and blue and of white.
std::string primaries_name(const std::array<std::array<double, 2>, 3>& rgb,
                           const std::array<double, 2>& white);

/// The name of a power curve: "linear", "power-2.2" (1/2.2, which countless sRGB files declare as the nearest
/// power) or, for example, "gamma 0.6".
///   exponent   of encoding: code = light ^ exponent
std::string power_curve_name(double exponent);

}  // namespace etak
