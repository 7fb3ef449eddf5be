// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/color/colorspace.h"
#include "core/color/rgb.h"
#include "core/material/material.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/interpolate.h"

namespace etak {

/// Where the luminance of F0 lies against Hoffman's forbidden zone, the open interval (0.20, 0.45): few real
/// materials are there (semiconductors), so an authored value inside it is most often a mistake.
enum class Zone { below, inside, above };
inline constexpr double forbidden_zone_first = 0.20;
inline constexpr double forbidden_zone_last = 0.45;
Zone zone_of(double luminance);
std::string_view name(Zone zone);  // "below", "inside", "above"

/// The medium in front of the material, without absorption.
///   index   constant n > 0, or n by table or formula
struct OutsideMedium {
  std::string label = "vacuum";
  std::variant<double, OpticalConstants> index = 1.0;
};

/// An output space that etak does not build itself, such as one of an OpenColorIO config.
///   convert   takes XYZ (Y = 1 for a perfect reflector) and the white under which it was seen to the linear
///             values of the space
struct CustomSpace {
  std::string name;
  std::function<LinearRgb(const Xyz& color, const Xyz& white)> convert;
};

/// The instrument through which a reflectance is seen.
///   aperture   of an objective whose pupil is filled: the reflectance is the mean over its cone, uniform in the squared
///              sine, over s and p; below the index outside; 0: normal incidence alone
///   scatter    share of the reflected light that is lost, [0, 1]
struct Instrument {
  double aperture = 0, scatter = 0;
  bool any() const { return aperture > 0 || scatter > 0; }
};

/// How F0 is computed. The default is etak's reference policy; policy() prints it.
struct F0Options {
  Viewing viewing;
  Interpolation interpolation = Interpolation::linear;
  Method method = Method::nm1;
  double integration_bound = 1e-5;          // of X, Y and Z (Y = 1 for a perfect reflector); automatic only
  RgbSpace space = RgbSpace::srgb;          // of F0Result::linear, f82, f82_tint
  std::optional<CustomSpace> custom_space;  // when set, in place of `space`
  OutsideMedium outside;
  Instrument instrument;
  bool allow_extrapolation = false;
  bool f82 = true;    // fill in F0Result::f82 and f82_tint
  bool mean = false;  // fill in F0Result::mean, which is that of the bare reflectance, without an instrument
  // Keep the tables of a viewing of one's own (core/spectrum/own_viewing.h).
  std::shared_ptr<const Observer> own_observer;
  std::shared_ptr<const Illuminant> own_illuminant;
};

/// Name of the output space: of `custom_space` where set, else of `space`.
std::string space_name(const F0Options& options);

/// "n and k linear in wavelength, ends held; sum at 1 nm, 360-830 nm; CIE 1931 2-degree observer; D65; ..."
std::string policy(const F0Options& options);

/// Range and density of the data that a result was computed from.
struct Coverage {
  std::array<double, 3> weight{};  // share of the X, Y, Z weight inside the data's range, [0, 1]
  double first_nm = 0, last_nm = 0;
  std::size_t samples_400_700 = 0;  // table rows inside 400..700 nm; 0 for a formula
  // Between neighbouring rows, within 400..700 nm (its ends count); 0 for a formula.
  double largest_gap_nm = 0;
  bool is_formula = false;

  double least() const;  // smallest of the three weights
  friend bool operator==(const Coverage&, const Coverage&) = default;
};

/// The method that Method::automatic took, and the estimated error of that method.
struct IntegrationStep {
  Method method = Method::exact;
  double error = 0;          // the largest of X, Y and Z, estimated
  bool within_bound = true;  // false: even the exact method has an estimated error above the bound
  friend bool operator==(const IntegrationStep&, const IntegrationStep&) = default;
};

/// Reflectance at normal incidence as a colour, and what one must know to trust it.
struct F0Result {
  Xyz xyz;                            // under the chosen illuminant, Y = 1 for a perfect reflector
  LinearRgb linear;                   // in F0Options::space, never clipped
  LinearRgb srgb_linear;              // in linear sRGB, never clipped
  Srgb8 srgb8;                        // of srgb_linear, clipped to [0, 1] and rounded half up
  double luminance = 0;               // Y
  std::optional<LinearRgb> f82;       // reflectance at cos = 1/7, in `space`; none for reflectance data,
                                      // and through an aperture
  std::optional<LinearRgb> f82_tint;  // f82 / Schlick(F0, cos 1/7), channel by channel
  std::optional<LinearRgb> mean;  // over a diffuse hemisphere, the integral of 2 cos F d(cos), in `space`;
                                  // where the options ask for it; none for reflectance data
  std::optional<Zone> zone;       // none: refused, or no F0 but the colour of a surface
  std::array<bool, 3> channel_in_zone{};  // of srgb_linear; none of a surface
  std::array<double, 3> gamut_excess{};   // of `linear`: amount above 1 (positive) or below 0 (negative); 0
                                          // inside. XYZ has no gamut: always 0 there
  Coverage coverage;
  Flags flags;
  std::optional<IntegrationStep> integration;  // of Method::automatic
  std::string refusal;  // not empty: no colour was computed, and why; all but coverage and flags is unset

  bool refused() const { return !refusal.empty(); }
  bool out_of_gamut() const;
  friend bool operator==(const F0Result&, const F0Result&) = default;
};

/// The mean of F82's curve through F0 and F82 over a diffuse hemisphere, in closed form; none without F82.
std::optional<LinearRgb> mean_of_f82(const F0Result& result);

/// Seconds spent per stage; summed by the caller over threads.
struct F0Timing {
  double interpolate = 0, fresnel = 0, sum = 0;
};

/// Turns optics into F0 under fixed options. Built once, const and shared between threads in use.
class F0Solver {
 public:
  /// Throws Error when the outside medium absorbs visibly (k > 0.01 inside 360..830 nm) or lacks coverage,
  /// for an integration bound that is not above 0, and for what no instrument has.
  explicit F0Solver(F0Options options);
  ~F0Solver();
  F0Solver(F0Solver&&) noexcept;

  const F0Options& options() const;

  /// Never throws for doubtful data: those give a refused or flagged result.
  ///   data_flags   what the importer found; carried into the result
  ///   timing       when given, stage times are added to it
  F0Result solve(const Optics& optics, Flags data_flags = {}, F0Timing* timing = nullptr) const;

  /// F0 of a polycrystal whose grains lie every way: the reflectance spectra of the axes, weighted, and so
  /// the linear results too. (2 R_o + R_e) / 3 for uniaxial crystals, a third each for biaxial ones.
  ///   parts    at least one, weights sum to 1
  struct Part {
    const Optics* optics;
    double weight;
  };
  F0Result solve(const std::vector<Part>& parts, Flags data_flags = {}) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace etak
