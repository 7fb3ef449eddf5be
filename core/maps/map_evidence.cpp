// SPDX-License-Identifier: Apache-2.0
#include "core/maps/map_evidence.h"

#include <algorithm>
#include <cmath>

namespace etak {

namespace {

// Sums of squared deviations. What rounding leaves of a quantity that does not vary is none.
double squared_deviation(double of_squares, double of_values, std::uint64_t count) {
  const double out = count == 0 ? 0 : of_squares - of_values * of_values / static_cast<double>(count);
  return out > 1e-9 * of_squares ? out : 0;
}

double ratio_or_0(double over, double under) {
  return under > 0 ? over / under : 0;
}

// Length that is lost where the map varies, by averaging without making the normals unit again.
bool is_shrunk(const NormalShape& s) {
  // Averaging takes a part of the length; what has lost a third on the average is no map of normals.
  if (3 * s.loss.y > static_cast<double>(s.loss.count)) return false;
  const double mean_loss = ratio_or_0(s.loss.xy, s.loss.x);
  // Rounding gives each colour an error of its own, which only many colours average out.
  const double least_loss = s.steep_colors >= 256 ? 0.001 : 0.0075;
  if (mean_loss >= least_loss && s.loss.slope() >= 0.25 && s.loss.slope_errors() >= 10) return true;
  // Noise as fine as the texels loses everywhere alike; a weaker contrast would be short in smooth places
  // too.
  const bool is_short_everywhere = 10 * s.too_short >= 3 * s.texels && 20 * s.too_long <= s.too_short;
  const bool is_short_in_smooth = s.smooth >= 100 && 10 * s.smooth_short >= 3 * s.smooth;
  return is_short_everywhere && !is_short_in_smooth && s.loss.x > 1e-3 * static_cast<double>(s.texels);
}

}  // namespace

double PairSums::correlation() const {
  const double over = count == 0 ? 0 : xy - x * y / static_cast<double>(count);
  return ratio_or_0(over, std::sqrt(squared_deviation(xx, x, count) * squared_deviation(yy, y, count)));
}

double PairSums::correlation_about_zero() const {
  return ratio_or_0(xy, std::sqrt(xx * yy));
}

double PairSums::slope() const {
  return count == 0 ? 0
                    : ratio_or_0(xy - x * y / static_cast<double>(count), squared_deviation(xx, x, count));
}

double PairSums::slope_errors() const {
  if (count < 3) return 0;
  const double left = 1 - correlation() * correlation();
  return correlation() * std::sqrt(static_cast<double>(count - 2) / std::max(left, 1e-12));
}

std::uint64_t GreyFacts::between(int first, int last) const {
  std::uint64_t out = 0;
  for (int code = first; code <= last; ++code) out += codes[static_cast<std::size_t>(code)];
  return out;
}

NormalDamage damage_of(const MapEvidence& map) {
  const auto how = normal_codes(map.normals);
  if (!how) return NormalDamage::empty;
  if (map.shape.grey * 100 >= map.normals.texels * 99) return NormalDamage::height;
  if (*how == NormalCodes::encoded || *how == NormalCodes::decoded) return NormalDamage::encoded;
  if (is_constant(map.normals)) return NormalDamage::constant;
  if (map.jpeg) return NormalDamage::jpeg;
  if (*how != NormalCodes::two_channels && is_shrunk(map.shape)) return NormalDamage::shrunk;
  return NormalDamage::none;
}

MeasuredGreen measured_green(const MapEvidence& map) {
  constexpr double least_agreement = 0.5;
  constexpr std::uint64_t least_texels = 64;
  const PairSums &twist = map.shape.twist, &x = map.shape.relief_x, &y = map.shape.relief_y;
  const double own = twist.correlation_about_zero();
  if (twist.count >= least_texels && std::abs(own) >= least_agreement)
    return {own < 0 ? GreenAxis::opengl : GreenAxis::directx, std::abs(own), false};
  const double along = x.correlation_about_zero(), down = y.correlation_about_zero();
  const double beside = std::min(std::abs(along), std::abs(down));
  if (x.count < least_texels || y.count < least_texels || beside < least_agreement) return {};
  // Slopes upwards are those downwards with the other sign.
  return {along * down < 0 ? GreenAxis::opengl : GreenAxis::directx, beside, true};
}

}  // namespace etak
