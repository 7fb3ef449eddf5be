// SPDX-License-Identifier: Apache-2.0
// Based on:
//   CIE 015:2018, section 8: CIELAB
//   Sharma, Wu and Dalal 2005, "The CIEDE2000 Color-Difference Formula: Implementation Notes", equations 2-22
#include "core/color/delta_e.h"

#include <cmath>
#include <numbers>

#include "core/color/colorspace.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

double cube_root_or_line(double t) {
  constexpr double knee = 6.0 / 29;
  return t > knee * knee * knee ? math::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29;
}

double hue_degrees(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double h = math::atan2(b, a) * degrees;
  return h < 0 ? h + 360 : h;
}

double length(double a, double b) {
  return std::sqrt(a * a + b * b);
}

double pow7_ratio(double chroma) {
  const double c2 = chroma * chroma, c7 = c2 * c2 * c2 * chroma;
  return std::sqrt(c7 / (c7 + 6103515625.0));  // 25^7
}

// A hue as the point of its angle on the unit circle.
struct Hue {
  double x, y;
  static Hue of(double degree) { return {math::cos(degree / degrees), math::sin(degree / degrees)}; }
};

double cosine(const Hue& hue, const Hue& less) {  // of the difference of their angles
  return hue.x * less.x + hue.y * less.y;
}
Hue added(const Hue& a, const Hue& b) {  // of their angles
  return {a.x * b.x - a.y * b.y, a.y * b.x + a.x * b.y};
}

// The hue's share of the weight of hue differences (Sharma eq. 15).
double hue_weight(const Hue& mean) {
  static const Hue at_30 = Hue::of(30), at_minus_6 = Hue::of(-6), at_63 = Hue::of(63);
  const Hue twice = added(mean, mean);
  return 1 - 0.17 * cosine(mean, at_30) + 0.24 * twice.x + 0.32 * cosine(added(twice, mean), at_minus_6) -
         0.20 * cosine(added(twice, twice), at_63);
}

// How far blue hues are turned, in degrees (eq. 16).
double turn_degrees(const Hue& mean) {
  if (mean.y >= 0 && mean.x > -0.48) return 0;  // below 119 degrees it is less than 1e-15
  return 30 * math::exp(-math::pow((hue_degrees(mean.x, mean.y) - 275) / 25, 2));
}

// By what differences of lightness, chroma and hue are divided, and how much the last two turn into each other.
struct Scales {
  double l, c, h, turn;
};
Scales scales(double mean_l, double mean_c2, const Hue& mean) {
  const double l50 = (mean_l - 50) * (mean_l - 50);
  const double sl = 1 + 0.015 * l50 / std::sqrt(20 + l50);
  const double sc = 1 + 0.045 * mean_c2;
  const double sh = 1 + 0.015 * mean_c2 * hue_weight(mean);
  const double turn = turn_degrees(mean);
  const double rt = turn == 0 ? 0 : -2 * pow7_ratio(mean_c2) * math::sin(2 * turn / degrees);
  return {sl, sc, sh, rt};
}

}  // namespace

Lab to_lab(const Xyz& color, const Xyz& white) {
  const double fx = cube_root_or_line(color.x / white.x);
  const double fy = cube_root_or_line(color.y / white.y);
  const double fz = cube_root_or_line(color.z / white.z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Lab to_lab(const LinearRgb& srgb) {
  constexpr Xyz d65{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
  static const Mat3 matrix = rgb_to_xyz(primaries(RgbSpace::srgb), d65);
  return to_lab(to_xyz(matrix * vec(srgb)), d65);
}

double delta_e2000(const Lab& p, const Lab& q) {
  constexpr double opposite = 1e-9;  // sums of two hues that are shorter have no direction of their own
  const double mean_c = (length(p.a, p.b) + length(q.a, q.b)) / 2;
  const double stretch = 1 + 0.5 * (1 - pow7_ratio(mean_c));
  const double a1 = stretch * p.a, a2 = stretch * q.a;
  const double c1 = length(a1, p.b), c2 = length(a2, q.b);

  // The hue of the mean, and twice the sine of half the difference of hues. With one chroma zero there is no difference, and
  // the mean is the other's hue (Sharma eq. 10, 14).
  Hue mean{1, 0};
  double sine = 0;
  if (c1 * c2 != 0) {
    const Hue one{a1 / c1, p.b / c1}, other{a2 / c2, q.b / c2};
    const double both = length(one.x + other.x, one.y + other.y);
    const double across = one.x * other.y - one.y * other.x;
    if (both < opposite) {
      mean = Hue::of((hue_degrees(a1, p.b) + hue_degrees(a2, q.b)) / 2);
      sine = across < 0 ? -2 : 2;
    } else {
      mean = {(one.x + other.x) / both, (one.y + other.y) / both};
      sine = 2 * across / both;
    }
  } else if (c1 + c2 != 0) {
    mean = {(a1 + a2) / (c1 + c2), (p.b + q.b) / (c1 + c2)};
  }
  const double dl = q.l - p.l, dc = c2 - c1, dhue = std::sqrt(c1 * c2) * sine;
  const double mean_l = (p.l + q.l) / 2, mean_c2 = (c1 + c2) / 2;

  const Scales of = scales(mean_l, mean_c2, mean);
  const double l = dl / of.l, c = dc / of.c, h = dhue / of.h;
  return std::sqrt(l * l + c * c + h * h + of.turn * c * h);
}

Mat3 delta_e2000_around(const Lab& at) {
  const double stretch = 1 + 0.5 * (1 - pow7_ratio(length(at.a, at.b)));
  const double a = stretch * at.a, chroma = length(a, at.b);
  // Along the chroma and along the hue, in a and b.
  const double along = chroma > 0 ? a / chroma : 1, across = chroma > 0 ? at.b / chroma : 0;
  const Scales of = scales(at.l, chroma, {along, across});
  const Vec3 c{0, stretch * along / of.c, across / of.c}, h{0, -stretch * across / of.h, along / of.h};
  const auto sum = [&](double ca, double cb, double ha, double hb) {
    return ca * cb + ha * hb + of.turn * (ca * hb + cb * ha) / 2;
  };
  const double both = sum(c[1], c[2], h[1], h[2]);
  return {{{1 / (of.l * of.l), 0, 0},
           {0, sum(c[1], c[1], h[1], h[1]), both},
           {0, both, sum(c[2], c[2], h[2], h[2])}}};
}

}  // namespace etak
