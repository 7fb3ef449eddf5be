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

double cos_degrees(double x) {
  return math::cos(x / degrees);
}

double pow7_ratio(double chroma) {
  const double c7 = math::pow(chroma, 7);
  return std::sqrt(c7 / (c7 + 6103515625.0));  // 25^7
}

// By what differences of lightness, chroma and hue are divided, and how much the last two turn into each other.
struct Scales {
  double l, c, h, turn;
};
Scales scales(double mean_l, double mean_c2, double mean_h) {
  const double t = 1 - 0.17 * cos_degrees(mean_h - 30) + 0.24 * cos_degrees(2 * mean_h) +
                   0.32 * cos_degrees(3 * mean_h + 6) - 0.20 * cos_degrees(4 * mean_h - 63);
  const double turn = 30 * math::exp(-math::pow((mean_h - 275) / 25, 2));
  const double l50 = (mean_l - 50) * (mean_l - 50);
  const double sl = 1 + 0.015 * l50 / std::sqrt(20 + l50);
  const double sc = 1 + 0.045 * mean_c2;
  const double sh = 1 + 0.015 * mean_c2 * t;
  const double rt = -2 * pow7_ratio(mean_c2) * math::sin(2 * turn / degrees);
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
  const double mean_c = (math::hypot(p.a, p.b) + math::hypot(q.a, q.b)) / 2;
  const double stretch = 1 + 0.5 * (1 - pow7_ratio(mean_c));
  const double a1 = stretch * p.a, a2 = stretch * q.a;
  const double c1 = math::hypot(a1, p.b), c2 = math::hypot(a2, q.b);
  const double h1 = hue_degrees(a1, p.b), h2 = hue_degrees(a2, q.b);

  double dh = 0,
         mean_h = h1 + h2;  // with one chroma zero: no hue difference, the sum as mean (Sharma eq. 10, 14)
  if (c1 * c2 != 0) {
    dh = h2 - h1;
    if (dh > 180) dh -= 360;
    if (dh < -180) dh += 360;
    mean_h = std::abs(h1 - h2) <= 180 ? (h1 + h2) / 2
             : h1 + h2 < 360          ? (h1 + h2 + 360) / 2
                                      : (h1 + h2 - 360) / 2;
  }
  const double dl = q.l - p.l, dc = c2 - c1;
  const double dhue = 2 * std::sqrt(c1 * c2) * math::sin(dh / 2 / degrees);
  const double mean_l = (p.l + q.l) / 2, mean_c2 = (c1 + c2) / 2;

  const Scales of = scales(mean_l, mean_c2, mean_h);
  const double l = dl / of.l, c = dc / of.c, h = dhue / of.h;
  return std::sqrt(l * l + c * c + h * h + of.turn * c * h);
}

Mat3 delta_e2000_around(const Lab& at) {
  const double stretch = 1 + 0.5 * (1 - pow7_ratio(math::hypot(at.a, at.b)));
  const double a = stretch * at.a, chroma = math::hypot(a, at.b);
  const Scales of = scales(at.l, chroma, hue_degrees(a, at.b));
  // Along the chroma and along the hue, in a and b.
  const double along = chroma > 0 ? a / chroma : 1, across = chroma > 0 ? at.b / chroma : 0;
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
