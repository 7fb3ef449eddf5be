// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/color/rgb.h"

namespace etak {

// How far a new publication of a material would lie from its stated F0. The rule is split-conformal: residuals of
// publications that were left out, each divided by a scale of its material, have quantiles; a quantile times the scale of
// another material is its radius (Lei, G'Sell, Rinaldo, Tibshirani and Wasserman 2018, "Distribution-Free Predictive
// Inference for Regression", J. Am. Stat. Assoc. 113, section 5.2). resources/doc/uncertainty.md has it in words.

/// Materials whose publications lie about as far apart from each other.
enum class BandClass : std::uint8_t { metal, semiconductor, clear };
inline constexpr std::size_t band_class_count = 3;
std::string_view name(BandClass kind);

/// How far a colour lies from another: CIEDE2000, and the absolute logarithms of the ratios of linear r, g, b and
/// luminance Y. A channel below 1e-4 counts as 1e-4.
using Offsets = std::array<double, 5>;
inline constexpr std::size_t offset_de = 0, offset_y = 4;
///   a, b   linear sRGB, unclipped
Offsets offsets(const LinearRgb& a, const LinearRgb& b);

/// The quantiles of the rule, which `fit_bands` makes from publications.
struct BandTable {
  /// The statistics of one class.
  ///   mean           of its residuals
  ///   half_one       median of its scaled residuals of materials with one other publication
  ///   half_several   with more than one
  struct OfClass {
    std::size_t materials = 0, publications = 0;
    Offsets mean{}, half_one{}, half_several{};
  };
  std::string made;  // when, and from what
  std::array<OfClass, band_class_count> classes;
  // The 0.9 quantiles of the scaled residuals of all classes: one class has too few for its own.
  Offsets nine_one{}, nine_several{};
  // CIEDE2000 between computed data and the measured ones of the same material, and the number of these pairs.
  std::size_t computed = 0;
  Offsets computed_half{}, computed_nine{};

  const OfClass& of(BandClass kind) const { return classes[static_cast<std::size_t>(kind)]; }
};

/// resources/bands.json.
const BandTable& shipped_bands();
/// Throws Error with the place of what is wrong.
BandTable parse_bands(std::string_view text, std::string_view file);
std::string format_bands(const BandTable& table);

/// Where new publications of a material would lie.
///   publications   that it rests on, with the stated one; 0: the stated F0 is computed
///   de50, de90     half of new ones would lie within this CIEDE2000 of the stated F0, nine of ten within that
///   low90, high90  nine of ten would have this channel of linear sRGB between these, channel by channel
///   y90            and this luminance
///   farthest       CIEDE2000 of the publication that lies farthest from the stated one
///   disagree       it lies farther off than nine of ten publications of this class lie from another
struct Band {
  std::size_t publications = 1;
  BandClass kind = BandClass::metal;
  double de50 = 0, de90 = 0;
  LinearRgb low90, high90;
  std::array<double, 2> y90{};
  double farthest = 0;
  bool disagree = false;
};

///   stated   linear sRGB, unclipped
///   others   of other publications; may be none
Band band(BandClass kind, const LinearRgb& stated, std::span<const LinearRgb> others,
          const BandTable& table = shipped_bands());

/// Whether a colour lies where nine of ten new publications would: by CIEDE2000, and in each channel.
///   stated   F0 that the band is of
///   slack    how much further a channel may lie, as a step of 8 bits does
bool lies_inside(const Band& band, const LinearRgb& stated, const LinearRgb& colour, double slack = 0);

/// Colours at the rim of the half band, to be looked at beside each other: darker, bluer, stated, redder, lighter. Red and blue are
/// changed by one factor, or all channels, until the colour lies de50 from the stated one.
std::array<LinearRgb, 5> half_band_colors(const Band& band, const LinearRgb& stated);

/// The band of an F0 that is computed from theory.
Band computed_band(BandClass kind, const LinearRgb& stated, const BandTable& table = shipped_bands());

/// "11 publications; half of new ones would lie within dE 0.8, nine of ten within 4.0".
std::string words(const Band& band);

/// The scale of a material for each kind of offset: the root of the mean of squares over its other publications and, once,
/// over the mean residual of its class.
Offsets band_scale(const Offsets& class_mean, std::span<const Offsets> others);

}  // namespace etak
