// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/color/rgb.h"
#include "core/math/mat3.h"

namespace etak {

/// Output spaces that etak builds from primaries; `xyz` is CIE XYZ itself (values X, Y, Z in r, g, b).
enum class RgbSpace { srgb, acescg, rec2020, display_p3, xyz };

inline constexpr std::array all_rgb_spaces{RgbSpace::srgb, RgbSpace::acescg, RgbSpace::rec2020,
                                           RgbSpace::display_p3, RgbSpace::xyz};

std::string_view name(RgbSpace space);  // "srgb", "acescg", "rec2020", "display-p3", "xyz"

/// The space that `text` is a common name of, in any case and with blanks, '-', '_' and '.' left out: "sRGB",
/// "Rec.709", "linear", "ACEScg", "BT.2020", "Display P3", "CIE XYZ". All are linear spaces here.
std::optional<RgbSpace> rgb_space_named(std::string_view text);

/// CIE 1931 chromaticities of the primaries: {{xr, yr}, {xg, yg}, {xb, yb}}. Not for `xyz`.
std::array<std::array<double, 2>, 3> primaries(RgbSpace space);

/// RGB to XYZ from primaries and a white with Y = 1 (SMPTE RP 177-1993): R = G = B = 1 gives `white`.
Mat3 rgb_to_xyz(const std::array<std::array<double, 2>, 3>& primaries, const Xyz& white);

/// Chromatic adaptation by Bradford (Lam 1985; linear form as in ICC.1:2010, annex E): maps white `from` onto
/// `to`.
Mat3 bradford(const Xyz& from, const Xyz& to);

/// The matrix from XYZ under `illuminant_white` (Y = 1) to linear `space`.
///   d65_white   white of D65 by the same observer and integration method: the white of sRGB, Rec.2020 and
///               Display P3 (ACEScg has its own: x 0.32168, y 0.33767). Where the illuminant's white is not
///               the white of the space, Bradford's adaptation takes one to the other
///   returns     a matrix that takes white to (1, 1, 1); for `xyz` the identity, so white stays white
Mat3 xyz_to_rgb(RgbSpace space, const Xyz& illuminant_white, const Xyz& d65_white);

}  // namespace etak
