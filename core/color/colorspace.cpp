// SPDX-License-Identifier: Apache-2.0
#include "core/color/colorspace.h"

#include <string>

#include "core/base/text/ascii.h"
#include "core/color/aces.h"

namespace etak {
namespace {

constexpr std::array<std::string_view, 5> space_names{"srgb", "acescg", "rec2020", "display-p3", "xyz"};

struct CommonName {
  std::string_view folded;
  RgbSpace space;
};

// Spaces of the same primaries and white; every one is linear, whatever curve its standard adds for codes.
constexpr std::array common_names{
    CommonName{"srgb", RgbSpace::srgb},
    CommonName{"linear", RgbSpace::srgb},
    CommonName{"linearsrgb", RgbSpace::srgb},
    CommonName{"srgblinear", RgbSpace::srgb},
    CommonName{"rec709", RgbSpace::srgb},
    CommonName{"bt709", RgbSpace::srgb},
    CommonName{"linearrec709", RgbSpace::srgb},
    CommonName{"acescg", RgbSpace::acescg},
    CommonName{"ap1", RgbSpace::acescg},
    CommonName{"acesap1", RgbSpace::acescg},
    CommonName{"rec2020", RgbSpace::rec2020},
    CommonName{"bt2020", RgbSpace::rec2020},
    CommonName{"linearrec2020", RgbSpace::rec2020},
    CommonName{"displayp3", RgbSpace::display_p3},
    CommonName{"lineardisplayp3", RgbSpace::display_p3},
    CommonName{"p3d65", RgbSpace::display_p3},
    CommonName{"xyz", RgbSpace::xyz},
    CommonName{"ciexyz", RgbSpace::xyz},
};

// The white of ACEScg, the one space here whose white is not D65.
constexpr Xyz aces_white{aces_white_x / aces_white_y, 1, (1 - aces_white_x - aces_white_y) / aces_white_y};

}  // namespace

std::string_view name(RgbSpace space) {
  return space_names[static_cast<std::size_t>(space)];
}

std::optional<RgbSpace> rgb_space_named(std::string_view text) {
  if (text.empty() || text.front() == ' ' || text.back() == ' ') return std::nullopt;
  std::string folded;
  for (const char c : text)
    if (c != ' ' && c != '-' && c != '_' && c != '.') folded += lower_case(c);
  for (const CommonName& each : common_names)
    if (folded == each.folded) return each.space;
  return std::nullopt;
}

std::array<std::array<double, 2>, 3> primaries(RgbSpace space) {
  switch (space) {
    case RgbSpace::acescg:
      return {{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}};  // AP1, S-2014-004
    case RgbSpace::rec2020:
      return {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}};  // ITU-R BT.2020-2
    case RgbSpace::display_p3:
      return {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}};  // SMPTE EG 432-1
    case RgbSpace::srgb:
    case RgbSpace::xyz:
      break;
  }
  return {{{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}}};  // IEC 61966-2-1
}

Mat3 rgb_to_xyz(const std::array<std::array<double, 2>, 3>& primaries, const Xyz& white) {
  Mat3 columns{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = primaries[c][0], y = primaries[c][1];
    columns[0][c] = x / y;
    columns[1][c] = 1;
    columns[2][c] = (1 - x - y) / y;
  }
  return columns * diagonal(inverse(columns) * vec(white));
}

Mat3 bradford(const Xyz& from, const Xyz& to) {
  constexpr Mat3 cone{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
  const Vec3 a = cone * vec(from), b = cone * vec(to);
  return inverse(cone) * diagonal({b[0] / a[0], b[1] / a[1], b[2] / a[2]}) * cone;
}

Mat3 xyz_to_rgb(RgbSpace space, const Xyz& illuminant_white, const Xyz& d65_white) {
  if (space == RgbSpace::xyz) return identity3;
  const Xyz white = space == RgbSpace::acescg ? aces_white : d65_white;
  const Mat3 to_rgb = inverse(rgb_to_xyz(primaries(space), white));
  return illuminant_white == white ? to_rgb : to_rgb * bradford(illuminant_white, white);
}

}  // namespace etak
