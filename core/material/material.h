// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/color/rgb.h"
#include "core/spectrum/spectrum.h"

namespace etak {

/// What was found in the data, or in the result made from them, that a user should know. Each flag has a
/// short name (`name(flag)`, kebab-case) that is part of the CSV and JSON interface.
enum class Flag : std::uint8_t {
  extrapolated,          // data do not cover 400..700 nm, or under 0.99 of one of the X, Y, Z weights
  out_of_gamut,          // a linear channel lies outside [0, 1]
  channel_in_zone,       // one channel, but not the luminance, lies in the forbidden zone
  gap,                   // neighbouring samples inside 400..700 nm are more than 20 nm apart
  single_sample,         // a table of one row
  unsorted,              // rows were not ascending and were sorted
  duplicate_wavelength,  // rows of equal wavelength and different values were averaged (or the first was
                         // kept)
  duplicate_dropped,     // identical rows were dropped
  negative_k,            // k below zero was taken as 0
  k_assumed_0,           // no k given
  k_range_short,         // k is tabulated over less of 360..830 nm than n; its end values are held
  n_not_positive,        // n at or below zero outside 360..830 nm
  formula_clamped,       // the formula was evaluated at the end of its stated range
  unpaired_coefficient,  // a formula's last coefficient has no partner and was left out
  outside_absorption_ignored,  // the outside medium's small k was taken as 0
  reflectance_clamped,         // tabulated reflectance up to 2 % outside [0, 1] was taken as 0 or 1
  finer_than_grid,             // samples closer than the step of the sum, which may miss what they hold
  computed,                    // the numbers come from theory alone
  sparse,                      // a table of fewer than 10 samples in 400..700 nm
  doubtful,                    // named so in its file, or far from the other datasets: quality.h
  unresolved_fringes,          // fringes of a stack's layers are too narrow for the step of the sum
};
inline constexpr std::size_t flag_count = 21;

std::string_view name(Flag flag);
std::string_view meaning(Flag flag);  // one sentence, for docs and pages
std::optional<Flag> flag_named(std::string_view text);

/// A set of flags, iterated in the order of the enumeration.
class Flags {
 public:
  void set(Flag flag) { bits_ |= bit(flag); }
  void clear(Flag flag) { bits_ &= ~bit(flag); }
  bool has(Flag flag) const { return (bits_ & bit(flag)) != 0; }
  bool none() const { return bits_ == 0; }
  Flags& operator|=(Flags other) {
    bits_ |= other.bits_;
    return *this;
  }
  std::uint32_t bits() const { return bits_; }
  static Flags from_bits(std::uint32_t bits) {
    Flags flags;
    flags.bits_ = bits;
    return flags;
  }
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i < flag_count; ++i)
      if (has(static_cast<Flag>(i))) visit(static_cast<Flag>(i));
  }
  friend bool operator==(Flags, Flags) = default;

 private:
  static std::uint32_t bit(Flag flag) { return 1u << static_cast<unsigned>(flag); }
  std::uint32_t bits_ = 0;
};

/// A dispersion formula n(wavelength) of refractiveindex.info's numbering (1 Sellmeier ... 9 exotic).
///   coefficients        C1, C2, ... for wavelengths in micrometres
///   first_nm, last_nm   stated range; outside of it the value at its end is held
struct DispersionFormula {
  int number = 1;
  std::vector<double> coefficients;
  double first_nm = 0;
  double last_nm = 0;
  friend bool operator==(const DispersionFormula&, const DispersionFormula&) = default;
};

/// n by table or formula, k by table or absent (then 0). k may have a grid of its own.
struct OpticalConstants {
  std::variant<Spectrum, DispersionFormula> n;
  std::optional<Spectrum> k;
  friend bool operator==(const OpticalConstants&, const OpticalConstants&) = default;
};

/// Reflectance at (near-)normal incidence, or total reflectance of a diffuse sample, in [0, 1].
struct Reflectance {
  Spectrum spectrum;
  friend bool operator==(const Reflectance&, const Reflectance&) = default;
};

/// Where numbers were published, and under which licence.
struct Citation {
  std::vector<std::string> authors;
  std::string title;
  std::string published_in;  // journal, volume, pages; or the report's name
  int year = 0;              // 0: not known
  std::string doi;           // without resolver; may be empty
  std::string url;           // may be empty
  std::string licence;       // of the numbers: SPDX id, "CC0-1.0"
  std::string via;           // where the numbers were taken from: collection and page
  friend bool operator==(const Citation&, const Citation&) = default;
};

/// A body that light goes through.
///   color     what D65 becomes over `depth_m` by exp(-4 pi k depth / wavelength), linear; white where
///             depth_m is 0
///   depth_m   the longest of 1 m, 0.1 m, 0.01 m and 0.001 m through which at least half of daylight passes;
///             0 where no absorption is known or more than 0.999 passes 1 m
///   n_d       n at helium's yellow line, 587.56 nm; none where the dataset's n does not reach it
///   v_d       Abbe's number (n_d - 1) / (n_F - n_C), with hydrogen's lines 486.13 nm and 656.27 nm
///             (ISO 7944); none where n does not reach them or does not fall from blue to red
struct ClearBody {
  LinearRgb color{1, 1, 1};
  double depth_m = 0;
  std::optional<double> n_d = {}, v_d = {};
  friend bool operator==(const ClearBody&, const ClearBody&) = default;
};

/// A medium of a stack: a dataset of a material.
///   body   of the base, where it is clear; its colour is in sRGB
struct StackMedium {
  std::string id, dataset;
  Citation citation;
  OpticalConstants constants;
  std::optional<ClearBody> body = {};
  friend bool operator==(const StackMedium&, const StackMedium&) = default;
};

/// A layer of a stack.
///   medium     index in Stack::media
///   coherent   whether light that is reflected at its two sides interferes
struct StackLayer {
  std::size_t medium = 0;
  double thickness_nm = 0;
  bool coherent = true;
  friend bool operator==(const StackLayer&, const StackLayer&) = default;
};

/// Flat layers on a base, numbered from the outside.
///   text    that says so: "anatase:40nm/titanium" (core/material/stack_text.h)
///   media   each once; none: the names in the text have not been looked up (open_stacks() in core/material/stack.h)
///   base    index in media
struct Stack {
  std::string text;
  std::vector<StackMedium> media;
  std::vector<StackLayer> layers;
  std::size_t base = 0;
  bool is_open() const { return !media.empty(); }
  friend bool operator==(const Stack&, const Stack&) = default;
};

/// What one source says of one sample: n, k or reflectance; or the layers that it is made of.
using Optics = std::variant<OpticalConstants, Reflectance, Stack>;

/// What messages say of optics that are no n and k: "has reflectance data only", "is a stack of layers".
std::string_view without_constants(const Optics& optics);

/// unknown: the source does not say.
enum class Origin { measured, fit, computed, unknown };
std::string_view name(Origin origin);
std::optional<Origin> origin_named(std::string_view text);

/// The data of one source about one sample of a material.
struct Dataset {
  std::string id;  // unique within the material
  Optics optics;
  Origin origin = Origin::unknown;
  std::string sample;  // state of the sample, in etak's words; may be empty
  std::optional<double> temperature_kelvin;
  std::string axis;  // "ordinary", "extraordinary", "alpha", "beta", "gamma"; empty: isotropic or unstated
  Citation citation;
  Flags flags;           // what the importer found
  std::string note;      // may be empty
  std::string doubtful;  // why the numbers should not be relied on; empty: nobody says so
  friend bool operator==(const Dataset&, const Dataset&) = default;
};

/// Families of materials; conductors, semiconductors and dielectrics are told apart by optical_kind().
inline constexpr std::array<std::string_view, 15> material_classes{
    "metal", "alloy",   "conductor", "semiconductor", "gem",   "mineral", "crystal", "salt",
    "glass", "plastic", "organic",   "liquid",        "solid", "gas",     "surface"};

bool is_class(std::string_view text);

/// "conductor" (metal, alloy, conductor), "semiconductor", "surface" (measured reflectance of everyday
/// things) or "dielectric" (all the rest).
std::string_view optical_kind(std::string_view material_class);

/// Who says of which class a material is: its file or the user, the numbers (decide_class()), or nobody.
enum class ClassBy : std::uint8_t { stated, numbers, nobody };

/// What must be said where a material is asked for by one of its names: which steel "steel" is.
struct AliasNote {
  std::string alias;  // an alias of the material, or its id or name
  std::string note;
  friend bool operator==(const AliasNote&, const AliasNote&) = default;
};

/// Whether data of this class give an F0. Those of a surface give a diffuse colour: it has no place in or out
/// of the forbidden zone, and is never offered where an F0 is looked for.
bool gives_f0(std::string_view material_class);

/// A material with all its datasets, as its file holds it.
struct Material {
  std::string id;  // lower case, [a-z0-9_]
  std::string name;
  std::vector<std::string> aliases;
  std::vector<AliasNote> alias_notes;  // by alias
  // Why a body is not seen through as its n and k would have it, by a name of the material, for who asks for it
  // by that name (marble is calcite), or by the id of a dataset (blood).
  std::vector<AliasNote> bodies;
  std::string body;            // that of the name which was asked for; empty: none, or found by no name
  std::string material_class;  // where nobody states it, that of decide_class()
  ClassBy class_by = ClassBy::stated;
  std::string group;              // within the class, such as "wood"; may be empty
  bool common = false;            // as a surface so often seen that an unnamed F0 near it may be it (ETK101)
  std::vector<Dataset> datasets;  // at least one, ids unique
  std::size_t preferred = 0;      // index of the default dataset
  std::string preferred_reason;
  friend bool operator==(const Material&, const Material&) = default;

  const Dataset& preferred_dataset() const { return datasets[preferred]; }
  const Dataset* dataset(std::string_view dataset_id) const;
};

/// One line: "A. Author and B. Author, Title, Journal 1, 2 (1972), doi:...".
std::string one_line(const Citation& citation);

/// The citation of a dataset, and behind it those of the media of a stack.
std::string source_line(const Dataset& dataset);

/// One material of several: the first, and behind its datasets those of the others. Where a dataset's id is
/// taken it becomes "ID-2", "ID-3", ... A material without datasets where there are none.
Material merged(std::vector<Material> materials);

}  // namespace etak
