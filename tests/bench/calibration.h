// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/certainty/bands.h"

namespace etak {

/// F0 of one material by several publications.
///   colours     linear sRGB, one of each publication
///   preferred   index of the one that the library states; none: the one that is nearest to the others together
///   computed    by theory alone; not among `colours`
struct PublishedMaterial {
  std::string name;
  BandClass kind = BandClass::metal;
  std::vector<LinearRgb> colours;
  std::optional<std::size_t> preferred;
  std::vector<LinearRgb> computed;
};

/// Reads a table with the columns material, class, page, preferred, r, g, b and left_out; lines that begin with '#' are
/// skipped, and rows with a reason in left_out, but for "computed". Throws Error with file, line and what was expected.
std::vector<PublishedMaterial> parse_publications(std::string_view text, std::string_view file);

/// The colour that a material would have stated by these publications.
std::size_t stated_of(const PublishedMaterial& material, std::span<const std::size_t> known);

/// A publication that was left out: how far it lies from the F0 that the others would have stated.
///   others   how far those lie from it
struct Residual {
  std::size_t material = 0, publication = 0;
  BandClass kind = BandClass::metal;
  Offsets off{};
  std::vector<Offsets> others;
  bool several() const { return !others.empty(); }
};
/// Of all publications of all materials that have two or more.
std::vector<Residual> residuals(std::span<const PublishedMaterial> materials);

/// The quantiles of the residuals.
///   without   index of a material that is left out; none: all are in
BandTable band_table(std::span<const PublishedMaterial> materials, std::span<const Residual> residuals,
                     std::optional<std::size_t> without = {});

/// How many of the left-out publications lie inside of a radius, and how large it is on the mean.
struct BandCover {
  std::size_t count = 0, inside50 = 0, inside90 = 0;
  double de50 = 0, de90 = 0;  // sums
  void add(double off, double half, double nine);
};
/// By the rule of band(), by Student's t over the differences in Lab (the largest of three intervals), and by the plain
/// range of the known publications; each residual with a table that its material has no part in.
struct BandRules {
  BandCover conformal;
  std::array<BandCover, band_class_count> by_class;
  BandCover student, range;
};
BandRules leave_one_out(std::span<const PublishedMaterial> materials);

/// The share of left-out publications that lie within the radius of a nominal share, of all and by class: by the quantiles of
/// a class below pooled_from and by those of all classes from there on, as the rule takes 0.5 and 0.9.
struct CoverAt {
  double nominal = 0, all = 0;
  std::array<double, band_class_count> by_class{};
};
inline constexpr double pooled_from = 0.8;
CoverAt cover_at(std::span<const PublishedMaterial> materials, double nominal);

}  // namespace etak
