// SPDX-License-Identifier: Apache-2.0
// From reflectance at the nodes of a quadrature to colours, and which channels of them are out of gamut or in
// the forbidden zone.
#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0/f0_steps.h"

namespace etak {
namespace {

// Rounding errors do not put a perfect reflector out of gamut.
constexpr double gamut_tolerance = 1e-9;

LinearRgb in_space(const F0Options& options, const ColourSpaces& s, const Xyz& xyz) {
  return options.custom_space ? options.custom_space->convert(xyz, s.white) : to_rgb(s.to_space * vec(xyz));
}

}  // namespace

ColourSpaces colour_spaces(const F0Options& options, const Quadrature& q) {
  const Viewing d65{options.viewing.observer, Illuminant::d65};
  ColourSpaces s;
  Xyz d65_white;
  if (samples_rgb(options.method)) {
    s.white = to_xyz(make_quadrature(Method::nm1, options.viewing).white());
    d65_white = to_xyz(make_quadrature(Method::nm1, d65).white());
  } else {
    s.white = to_xyz(q.white());
    d65_white = options.viewing == d65            ? s.white
                : options.method == Method::exact ? to_xyz(make_exact_quadrature(d65, {}).white())
                                                  : to_xyz(make_quadrature(options.method, d65).white());
  }
  s.to_srgb = xyz_to_rgb(RgbSpace::srgb, s.white, d65_white);
  s.from_srgb = inverse(s.to_srgb);
  s.to_space = xyz_to_rgb(options.space, s.white, d65_white);
  if (options.custom_space)
    s.space_white = options.custom_space->convert(s.white, s.white);
  else if (options.space == RgbSpace::xyz)
    s.space_white = to_rgb(vec(s.white));
  return s;
}

std::optional<LinearRgb> mean_of_f82(const F0Result& result) {
  if (!result.f82) return std::nullopt;
  const auto [r, g, b] = result.linear;
  return LinearRgb{f64::f82_mean(r, result.f82->r), f64::f82_mean(g, result.f82->g),
                   f64::f82_mean(b, result.f82->b)};
}

F0Result with_colour(F0Result result, const F0Options& options, const Quadrature& q, const ColourSpaces& s,
                     std::span<const double> r0, std::span<const double> r82) {
  // A point method's sum is linear sRGB already; through XYZ and back it would only gain rounding.
  const auto colour = [&](std::span<const double> r, Xyz& xyz, LinearRgb& srgb) {
    const std::array<double, 3> sum = q.integrate(r);
    if (samples_rgb(options.method)) {
      srgb = to_rgb(sum);
      xyz = to_xyz(s.from_srgb * sum);
      return options.space == RgbSpace::srgb && !options.custom_space ? srgb : in_space(options, s, xyz);
    }
    xyz = to_xyz(sum);
    srgb = to_rgb(s.to_srgb * sum);
    return in_space(options, s, xyz);
  };
  result.linear = colour(r0, result.xyz, result.srgb_linear);
  result.srgb8 = options.method == Method::legacy_schueler ? power22_u8(result.srgb_linear)
                                                           : srgb_u8(result.srgb_linear);
  result.luminance = result.xyz.y;
  result.zone = zone_of(result.luminance);
  const Vec3 srgb = vec(result.srgb_linear);
  for (std::size_t c = 0; c < 3; ++c) {
    result.channel_in_zone[c] = zone_of(srgb[c]) == Zone::inside;
    if (result.channel_in_zone[c] && *result.zone != Zone::inside) result.flags.set(Flag::channel_in_zone);
  }
  const Vec3 linear = vec(result.linear), white = vec(s.space_white);
  const bool has_gamut = options.custom_space || options.space != RgbSpace::xyz;
  for (std::size_t c = 0; c < 3 && has_gamut; ++c) {
    const double excess = linear[c] > 1 ? linear[c] - 1 : std::min(linear[c], 0.0);
    if (std::abs(excess) <= gamut_tolerance) continue;
    result.gamut_excess[c] = excess;
    result.flags.set(Flag::out_of_gamut);
  }
  if (r82.empty()) return result;
  Xyz xyz82;
  LinearRgb srgb82;
  const Vec3 f82 = vec(colour(r82, xyz82, srgb82));
  result.f82 = to_rgb(f82);
  Vec3 tint;
  for (std::size_t c = 0; c < 3; ++c)
    tint[c] = f82[c] / (white[c] * f64::f_schlick(linear[c] / white[c], f82_cosine));
  result.f82_tint = to_rgb(tint);
  return result;
}

}  // namespace etak
