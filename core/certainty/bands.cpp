// SPDX-License-Identifier: Apache-2.0
#include "core/certainty/bands.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/text/text.h"
#include "core/color/colorspace.h"
#include "core/color/delta_e.h"
#include "core/color/luminance.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double least_channel = 1e-4;

double ratio(double a, double b) {
  return std::abs(math::log(std::max(a, least_channel) / std::max(b, least_channel)));
}

Offsets product(const Offsets& a, const Offsets& b) {
  Offsets out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] * b[i];
  return out;
}

// The band of a stated F0 from its radii at one half and nine tenths.
Band around(const LinearRgb& stated, double half, const Offsets& nine) {
  Band out;
  out.de50 = std::min(half, nine[offset_de]);
  out.de90 = nine[offset_de];
  const auto low = [&](double value, std::size_t i) { return value * math::exp(-nine[i]); };
  const auto high = [&](double value, std::size_t i) { return value * math::exp(nine[i]); };
  out.low90 = {low(stated.r, 1), low(stated.g, 2), low(stated.b, 3)};
  out.high90 = {high(stated.r, 1), high(stated.g, 2), high(stated.b, 3)};
  const double y = luminance_of(vec(stated));
  out.y90 = {low(y, offset_y), high(y, offset_y)};
  return out;
}

std::string radii(const Band& band, std::string_view of) {
  return "half of " + std::string(of) + " would lie within dE " + fixed(band.de50, 1) +
         ", nine of ten within " + fixed(band.de90, 1);
}

}  // namespace

std::string_view name(BandClass kind) {
  constexpr std::array<std::string_view, band_class_count> names{"metal", "semiconductor", "clear"};
  return names[static_cast<std::size_t>(kind)];
}

Offsets offsets(const LinearRgb& a, const LinearRgb& b) {
  return {delta_e2000(to_lab(a), to_lab(b)), ratio(a.r, b.r), ratio(a.g, b.g), ratio(a.b, b.b),
          ratio(luminance_of(vec(a)), luminance_of(vec(b)))};
}

Offsets band_scale(const Offsets& class_mean, std::span<const Offsets> others) {
  Offsets out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = class_mean[i] * class_mean[i];
    for (const Offsets& other : others) sum += other[i] * other[i];
    out[i] = std::sqrt(sum / double(1 + others.size()));
  }
  return out;
}

Band band(BandClass kind, const LinearRgb& stated, std::span<const LinearRgb> others,
          const BandTable& table) {
  std::vector<Offsets> off;
  double farthest = 0;
  for (const LinearRgb& other : others) {
    off.push_back(offsets(stated, other));
    farthest = std::max(farthest, off.back()[offset_de]);
  }
  const BandTable::OfClass& of = table.of(kind);
  const Offsets scale = band_scale(of.mean, off);
  const bool several = !others.empty();
  const double half = scale[offset_de] * (several ? of.half_several : of.half_one)[offset_de];
  Band out = around(stated, half, product(scale, several ? table.nine_several : table.nine_one));
  out.kind = kind;
  out.publications = 1 + others.size();
  out.farthest = farthest;
  out.disagree = farthest > of.mean[offset_de] * table.nine_one[offset_de];
  return out;
}

bool lies_inside(const Band& band, const LinearRgb& stated, const LinearRgb& colour, double slack) {
  // A saturated colour may be near enough to a grey metal whose publications disagree in lightness, though none of them
  // is coloured: the channels tell.
  const Vec3 low = vec(band.low90), high = vec(band.high90), at = vec(colour);
  for (std::size_t c = 0; c < 3; ++c)
    if (!(at[c] >= low[c] - slack && at[c] <= high[c] + slack)) return false;
  return delta_e2000(to_lab(stated), to_lab(colour)) <= band.de90;
}

std::array<LinearRgb, 5> half_band_colors(const Band& band, const LinearRgb& stated) {
  // The colour whose channels are multiplied by powers of one factor.
  const auto at_rim = [&](const Vec3& powers) {
    const auto changed = [&](double t) {
      return LinearRgb{stated.r * math::exp(t * powers[0]), stated.g * math::exp(t * powers[1]),
                       stated.b * math::exp(t * powers[2])};
    };
    double low = 0, high = 2;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (delta_e2000(to_lab(stated), to_lab(changed(middle))) < band.de50 ? low : high) = middle;
    }
    return changed(low);
  };
  return {at_rim({-1, -1, -1}), at_rim({-1, 0, 1}), stated, at_rim({1, 0, -1}), at_rim({1, 1, 1})};
}

Band computed_band(BandClass kind, const LinearRgb& stated, const BandTable& table) {
  Band out = around(stated, table.computed_half[offset_de], table.computed_nine);
  out.kind = kind;
  out.publications = 0;
  return out;
}

std::string words(const Band& band) {
  if (band.publications == 0) return "computed from theory; " + radii(band, "measurements");
  if (band.publications == 1) {
    const std::string_view kind = band.kind == BandClass::clear ? "clear material" : name(band.kind);
    return "one publication: for a " + std::string(kind) + " with one, " + radii(band, "new ones");
  }
  return std::to_string(band.publications) + " publications" +
         (band.disagree ? " that disagree by up to dE " + fixed(band.farthest, 1) : "") + "; " +
         radii(band, "new ones");
}

}  // namespace etak
