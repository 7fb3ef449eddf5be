// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/certainty/bands.h"
#include "core/material/catalogue.h"

namespace etak {

// Which material could a colour be? Each material with a band is a hypothesis: colours of new publications of it lie about
// its stated F0 with the density of a bivariate Cauchy distribution in CIEDE2000 whose scale is a sixth of the band's
// nine-tenths radius. The form and the sixth were chosen once on the publications that the library holds;
// resources/doc/uncertainty.md says how well probabilities and shares agree.

/// The largest linear channel of a colour that is asked for; the least is 0.
inline constexpr double largest_asked = 1.1;

/// What is asked.
///   f0          linear sRGB, each channel within [0, largest_asked]
///   f82         reflectance at cosine 1/7, as a second witness
///   eight_bit   the colour was rounded to 8 bits, so that differences below a code say nothing
struct AskedColour {
  LinearRgb f0;
  std::optional<LinearRgb> f82;
  bool eight_bit = false;
};

/// A material that a colour could be, as the library states it.
struct Hypothesis {
  std::string id, name, material_class;
  LinearRgb f0;
  Srgb8 codes;
  std::optional<LinearRgb> f82;
  Band band;
};

/// A hypothesis beside a colour.
///   p            probability among the materials of the library
///   delta_e      CIEDE2000 between the colour and its F0
///   band_share   delta_e over the band's nine-tenths radius
struct PossibleMaterial {
  const Hypothesis* entry = nullptr;
  double p = 0, delta_e = 0, band_share = 0;
};

/// none: the colour lies outside of the nine-tenths band of every material, by CIEDE2000 or in a channel; sure: the first has p of at least 0.8.
enum class ColourVerdict { sure, ambiguous, none };
std::string_view name(ColourVerdict verdict);
inline constexpr double sure_probability = 0.8;

/// The answer to one colour.
///   candidates   the most probable first, until they hold 0.9 together, and at least three (of fewer: all)
///   groups       not_told_apart()
struct Identified {
  ColourVerdict verdict = ColourVerdict::none;
  std::vector<PossibleMaterial> candidates;
  std::vector<std::vector<std::size_t>> groups;
};

/// Throws Error (with `place`) for a colour that is outside of [0, largest_asked].
void check_asked(const AskedColour& asked, std::string_view place);

/// A prior: weights by material; those that it does not name have 1.
using Prior = std::map<std::string, double, std::less<>>;
/// Reads a CSV with the columns id and weight. Throws Error with file and line, for a weight below 0, for an id that is no
/// material with a band, and where it names none.
Prior parse_prior(std::string_view text, std::string_view file, const MaterialLibrary& library);

/// The F0 that a material states, with its band.
struct BandOfF0 {
  LinearRgb stated;
  std::optional<Band> band;
};
/// Indices of those that cannot be told apart: half of the new publications of one would lie as far off as the other's F0
/// does, each in the first group that it fits; only groups of two or more.
std::vector<std::vector<std::size_t>> not_told_apart(std::span<const BandOfF0> all);

/// The F0 of the materials that nearest_materials() has found, with bands; none of a mean over the axes of a crystal.
///   solver   as of the catalogue that they are from
std::vector<BandOfF0> bands_of(std::span<const NearMaterial> found, const F0Solver& solver,
                               bool axis_average = false);

/// The options by which hypotheses for colours without F82 are computed: F82 of them all is a quarter of the work.
F0Options without_f82(F0Options options = {});

/// The materials with bands of a library, as hypotheses. Built once, const and shared between threads in use.
class Identifier {
 public:
  /// Materials with a band under the solver's options, on `threads` threads.
  ///   classes   only these; empty: all. Throws Error for a class that no material can have
  Identifier(const MaterialLibrary& library, const F0Solver& solver, const std::vector<std::string>& classes,
             unsigned threads);

  Identified identify(const AskedColour& asked, const Prior& prior = {}) const;

  /// Puts a material in the place of the hypothesis of that id; none: takes it out.
  void replace(std::string_view id, std::optional<Material> material, const F0Solver& solver);

 private:
  std::vector<Hypothesis> hypotheses_;
};

}  // namespace etak
