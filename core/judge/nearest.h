// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/once.h"
#include "core/certainty/identify.h"
#include "core/color/rgb.h"
#include "core/judge/finding.h"
#include "core/judge/settings.h"
#include "core/material/library.h"

namespace etak {

/// F0 of one dataset of a library.
struct KnownF0 {
  std::string id, name, dataset;  // material id and name
  bool preferred = false;
  bool conductor = false;          // metals, alloys, conductors
  bool common = false;             // Material::common
  bool gem = false;                // of the class gem
  bool metal = false;              // a conductor or semiconductor, or layers on one
  bool layers = false;             // layers on a base
  std::array<double, 3> linear{};  // linear sRGB, not clipped
  std::optional<LinearRgb> f82;    // at cos 1/7, where n and k give it
  double luminance = 0;
  std::optional<Band> band = {};  // of what a common material states
};

/// The band of a material's stated F0, and whether a colour may be the material's though no dataset is near.
///   holds   nine of ten new publications of the material would lie where the colour does, and it is not within `codes` of
///           the stated F0 of another conductor, because then it is the other's
struct NamedBand {
  Band band;
  bool holds = false;
};

/// Nothing where the material has no band.
///   others   of the library; those of the material itself do not count
///   linear   linear sRGB
std::optional<NamedBand> named_band(const Material& material, std::span<const KnownF0> others,
                                    const std::array<double, 3>& linear, TextureTransfer transfer,
                                    double codes);

/// A dataset of a material, and the other ones.
///   luminance   of its F0
///   others      their ids and luminances of F0
struct NamedDataset {
  std::string material, dataset;
  double luminance = 0;
  std::vector<std::pair<std::string, double>> others;
};

/// "this dataset (palm-2018) lies in the zone; titanium's others at 0.59 (johnson-1974)".
std::string dataset_in_zone(const NamedDataset& dataset);

/// The materials of one library, by which textures are judged.
class KnownMaterials {
 public:
  explicit KnownMaterials(MaterialLibrary library);
  /// The materials of the library inside the program.
  static const KnownMaterials& builtin();

  /// A hash of the materials, because results depend on them; empty for the built-in ones.
  const std::string& hash() const { return hash_; }

  /// F0 of every dataset that gives one, without doubtful datasets that are not preferred. Computed in the
  /// first call, which may come from any thread.
  std::span<const KnownF0> f0() const;

  /// The entries of one material, by id, alias or name; empty: not in the library.
  std::vector<const KnownF0*> f0_of(std::string_view material) const;

  /// What the preferred dataset of a material without a specular F0 gives: the total reflectance of paper, as divided()
  /// makes a surface and a body of it.
  std::optional<KnownF0> total_of(std::string_view material) const;

  /// named_band() of the material of that id, alias or name.
  std::optional<NamedBand> band_around(std::string_view material, const std::array<double, 3>& linear,
                                       TextureTransfer transfer, double codes) const;

  /// The dataset of a material (id, alias or name) within `codes` of a colour, the nearest. One that is doubtful only because
  /// it lies far from the others counts where it was measured and is cited.
  std::optional<NamedDataset> dataset_around(std::string_view material, const std::array<double, 3>& linear,
                                             TextureTransfer transfer, double codes) const;

  /// Which materials a colour could be: those of `identify` without its probabilities below 0.1, at most three, as
  /// "could be titanium (p 0.52) or tin (p 0.20)"; empty where the colour lies outside of every band or of [0, 1.1].
  ///   metals   only conductors are told
  std::string could_be(const std::array<double, 3>& linear, bool metals = false) const;

  /// Whether the library has a material of that id, alias or name; those without a specular F0, such as paper, too.
  bool has(std::string_view material) const {
    return !material.empty() && library_.find(material).has_value();
  }

 private:
  KnownMaterials(MaterialLibrary library, std::string hash);

  MaterialLibrary library_;
  std::string hash_;
  mutable Once computed_, identifies_;
  mutable std::vector<KnownF0> f0_;
  mutable std::optional<Identifier> identifier_;
};

/// The materials that the settings name, else the built-in ones.
const KnownMaterials& known_materials(const Settings& settings);

/// Largest channel difference in codes between linear colours clipped to [0, 1].
double code_distance(const std::array<double, 3>& a, const std::array<double, 3>& b,
                     TextureTransfer transfer);
/// Between a linear colour and an entry.
double code_distance(const std::array<double, 3>& linear, const KnownF0& entry, TextureTransfer transfer);

/// CIEDE2000 between a linear colour and the F0 of an entry, both clipped to [0, 1].
double delta_e_of(const std::array<double, 3>& linear, const KnownF0& entry);

/// Whether half of new publications of a common material would lie as near to its stated F0 as a linear colour does. Only of
/// three publications or more: the band of fewer is that of their class.
bool in_half_band(const std::array<double, 3>& linear, const KnownF0& entry);

/// The entry of the least such difference.
///   wanted   which entries count; null: none of them does
const KnownF0* nearest_f0(const KnownMaterials& known, const std::array<double, 3>& linear,
                          const std::function<bool(const KnownF0&)>& wanted);

/// The `count` nearest materials, each by its nearest dataset, nearest first.
std::vector<NearestMaterial> nearest_materials(const KnownMaterials& known,
                                               const std::array<double, 3>& linear, TextureTransfer transfer,
                                               std::size_t count = 3);

/// The range of linear F0 of the library's dielectrics without gems; ice and water have the least.
inline constexpr double least_dielectric_f0 = 0.017, most_dielectric_f0 = 0.09;

/// Codes, both ends included.
struct CodeRange {
  int first, last;
  constexpr bool holds(int code) const { return code >= first && code <= last; }
};
/// That range in sRGB codes.
inline constexpr CodeRange dielectric_codes{36, 84};
/// That range where F0 is stored without the curve: 255 times F0, with 3 codes of noise at the upper end.
inline constexpr CodeRange linear_dielectric_codes{4, 26};
/// That range where F0 is encoded twice: the sRGB codes of 36 / 255 and 84 / 255 as linear values.
inline constexpr CodeRange doubled_dielectric_codes{105, 155};

/// How the code of an F0 may have come about, if it is one of a dielectric. For metals the value does not
/// tell that.
///   as_is     a dielectric of the library is within `distance` codes
///   doubled   the value was encoded twice
///   missing   the value was never encoded
struct Explanation {
  enum class Cause { none, as_is, doubled, missing } cause = Cause::none;
  double original = 0;  // the F0 that was meant
  double distance = 0;  // codes from the nearest dielectric under that cause
  std::string material;
};

/// The most likely explanation of a linear F0. Only a grey is explained; the cause is `none` unless some
/// dielectric of the library is within 4 codes.
Explanation explain_f0(const KnownMaterials& known, const std::array<double, 3>& linear,
                       TextureTransfer transfer);

}  // namespace etak
