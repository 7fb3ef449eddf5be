// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pages/material_plots.h"
#include "core/render/typed.h"

namespace etak {

// Plots of several curves as a command line or a call asks for them.

/// A surface that curves are drawn of: a material, or numbers as typed_surface() takes them. Without either, D, G and
/// V are those of any surface of the wished roughness.
struct CurveSubject {
  std::vector<std::string> words;
  std::shared_ptr<const Material> material;  // null: in numbers
  std::size_t dataset = 0;
};

inline constexpr std::array<std::string_view, 6> curve_kinds{"F", "D",    "G",
                                                             "V", "lobe", "R"};  // as CurveKind has them
inline constexpr std::array<std::string_view, 5> curve_channels{"luminance", "red", "green", "blue", "rgb"};

/// What is asked for.
///   of              one of curve_kinds
///   models, terms   ids; "spectrum" is the F of a material's data, which no term approximates
///   set             "NAME=NUMBER", for models and terms; a name that comes again begins the next curve
///   light_deg       from the normal, 0 to 89.9
///   step_deg        between angles, 0.01 to 45; the nearest that divides 90 evenly is taken
///   scale           of lobes: "linear" or "log"
///   straight        lobes over a straight axis instead of around the normal
///   surface         of every subject
///   options         those of surface.compute
struct CurveRequest {
  std::string of = "F", channel = "luminance", scale = "linear";
  std::vector<std::string> models, terms, set;
  double light_deg = 45, step_deg = 0.5;
  bool straight = false;
  SurfaceWishes surface;
  F0Options options;
};

/// The plot, and the same around the normal where the request is for that.
struct AskedCurves {
  LinePlot plot;
  std::optional<PolarPlot> polar;

  /// "csv", "json" or "svg".
  std::string text(std::string_view form, std::string_view of, bool dark) const;
};

/// The words of each subject: a material is one word. Of numbers each name stands once; where a name comes again,
/// the next group begins.
std::vector<std::vector<std::string>> curve_groups(const std::vector<std::string>& words);

/// Throws Error for what the curves of this kind do not have.
///   subjects   how many there are
void check(const CurveRequest& request, std::size_t subjects);

/// The curves of every subject. Throws Error.
///   remarks   gets what was assumed, and a line for every value that was clamped to the range of its parameter
AskedCurves asked_curves(const CurveRequest& request, std::span<const CurveSubject> subjects,
                         std::vector<std::string>& remarks);

}  // namespace etak
