// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/color/gloss.h"
#include "core/iridescence/parameters.h"
#include "core/material/appearance.h"
#include "core/material/f0.h"
#include "core/material/f0_coat.h"
#include "core/material/material.h"

namespace etak {

// The start of every form of export: a surface as etak knows it, and how values that a target cannot hold are
// brought into its range. Nothing is changed without a Change beside the result.

enum class SurfaceKind { metal, dielectric };
std::string_view name(SurfaceKind kind);  // "metal", "dielectric"

/// A stack as the forms of renderers take it.
///   choice   which numbers of a form are exported: those that its advice names, or the ones that are said
///   adobe    OpenPBR's numbers are those for Adobe's renderer, else for MaterialX's graph
struct ExportFilm {
  /// A set of numbers of a form.
  enum class Choice { advised, honest, fitted };
  std::shared_ptr<const FilmFits> fits;
  Choice choice = Choice::advised;
  bool adobe = false;

  /// Of a form that the base has, and of honest numbers where there are some.
  const FilmValues& values(std::string_view form) const;
  friend bool operator==(const ExportFilm&, const ExportFilm&) = default;
};

/// n and k at a wavelength.
struct IndexSample {
  double nm = 0, n = 1, k = 0;
  friend bool operator==(const IndexSample&, const IndexSample&) = default;
};

/// A surface to export: Schueler's four parameters, what is known of its edge and of its body.
struct ExportSurface {
  std::string id;      // "gold": what it is called in files
  std::string name;    // "Gold"
  std::string source;  // where F0 comes from and how good it is, one line; may be empty
  std::string band;    // how far new publications would lie from it, one line; empty: not known
  SurfaceKind kind = SurfaceKind::dielectric;
  RgbSpace space = RgbSpace::srgb;  // of all colours here, linear
  LinearRgb f0{0.04, 0.04, 0.04};   // unclipped
  std::optional<LinearRgb> f82;     // absolute reflectance at cos 1/7; none: not known
  LinearRgb diffuse{0, 0, 0};       // Schueler's: used unchanged, not reduced by what is reflected
  std::optional<LinearRgb> total;   // measured: what f0 and diffuse add up to at normal incidence
  std::optional<ClearBody> clear;   // of a dielectric without diffuse
  std::optional<CoatedF0> coat;     // in air; f0 and f82 are those of the base without it
  std::optional<ExportFilm> film;   // of a stack: f0 and f82 are those of layers and base together
  std::optional<FilmTruth> seen;    // the exact F over the angle, F0's spectra and medium outside
  std::string unseen = "no spectra are behind it";  // where that is not known: why
  std::vector<IndexSample>
      spectrum;               // n and k against vacuum, 360 to 830 nm in steps of 5; empty: of no one medium
  std::string node;           // what it is called in a document, where that is not its id
  std::optional<double> ior;  // of the body, where f0 is not that of its surface in air
  Gloss gloss = 0.75;         // how rough: Schueler's gloss or perceptual roughness, [0, 1]
  double opacity = 1;         // [0, 1]
  LinearRgb emission{0, 0, 0};     // radiance that the surface sends out by itself, >= 0
  std::vector<std::string> notes;  // what was assumed, and what is against the data
  /// Name, source and band, as documents tell them.
  std::string title() const {
    return name + (source.empty() ? "" : ": " + source) + (band.empty() ? "" : "; " + band);
  }
  const std::string& node_name() const { return node.empty() ? id : node; }
  friend bool operator==(const ExportSurface&, const ExportSurface&) = default;
};

/// The surface of a material whose dataset gave `result` under `options`. Conductors and semiconductors are
/// metals without diffuse; `surface` data are a diffuse colour over an F0 of 0.04 which add up to what was
/// measured (divided() in core/material/appearance.h); the rest are dielectrics with `diffuse`, clear where
/// that is black and clarity() says so. What was assumed stands in the notes.
///   result   not refused; F0 is taken in options.space (a custom space is not looked at)
///   gloss    none: the default of the material's class
ExportSurface export_surface(const Material& material, const Dataset& dataset, const F0Options& options,
                             const F0Result& result, const LinearRgb& diffuse, std::optional<Gloss> gloss);

/// An emission as a colour of at most 1 and a factor of at least 1: what formats take that end at 1.
struct EmissionParts {
  LinearRgb color;
  double strength = 1;
};
EmissionParts emission_parts(const LinearRgb& emission);

/// What an authored pair of colours is meant to be: a metal where F0 is bright (luminance at or above the end
/// of the forbidden zone) and the body black.
SurfaceKind authored_kind(const LinearRgb& diffuse, const LinearRgb& f0);

/// Throws Error for a gloss, roughness or opacity outside [0, 1], a negative or non-finite colour but for F0
/// out of gamut.
void validate(const ExportSurface& surface);

/// The index of a clear dielectric that reflects f0 at normal incidence: (1 + sqrt f0) / (1 - sqrt f0).
double ior_of_f0(double f0);

/// Y of a linear colour of `space`.
double luminance(const LinearRgb& color, RgbSpace space);

/// How a colour that a target cannot hold is brought into [0, 1].
///   clamp          every channel by itself: F0 of gold loses red alone and turns a little yellower
///   preserve_hue   mixed with the grey of its own luminance until no channel is below 0, then divided by its
///                  largest channel: the ratios of the channels stay, gold gets 4 % darker
enum class Fit { clamp, preserve_hue };
std::string_view name(Fit fit);  // "clamp", "preserve-hue"
std::optional<Fit> fit_named(std::string_view text);

/// A value that a target does not hold, and what it gets.
///   action   how: "clamp", "preserve-hue"; "luminance" (one number for three); "schlick" (the edge is the
///            target's own curve); "fixed" (the target takes no value); "tint" (F0 is right, the rim is not);
///            "nearest" (no value gives both of two)
struct Change {
  std::string field;
  std::vector<double> wanted, used;  // one or three numbers
  std::string action, reason;

  double amount() const;  // the largest |used - wanted|
  friend bool operator==(const Change&, const Change&) = default;
};
using Changes = std::vector<Change>;

/// "base_color 1.0428 0.7738 0.3347 -> 1 0.7738 0.3347 (clamp, 0.0428): reason"
std::string one_line(const Change& change);

/// What a field for a colour holds: channels of [0, most] in `space`, and how others are brought there.
struct ColorRange {
  Fit fit = Fit::clamp;
  double most = 1;
  RgbSpace space = RgbSpace::srgb;
};

/// `color` brought into the range; a Change is added where that alters it.
LinearRgb fitted(const LinearRgb& color, const ColorRange& range, std::string_view field,
                 std::string_view reason, Changes& changes);

/// `value` clamped to [least, most], likewise.
double fitted(double value, double least, double most, std::string_view field, std::string_view reason,
              Changes& changes);

/// Adds a Change where any number differs by more than 1e-6.
void note_change(Changes& changes, std::string_view field, std::vector<double> wanted,
                 std::vector<double> used, std::string_view action, std::string_view reason);

/// Schlick at cos 1/7 per channel, and the tint that takes it to f82: 1 where no f82 is known.
LinearRgb schlick82(const LinearRgb& f0);
LinearRgb tint82(const ExportSurface& surface, const LinearRgb& f0);

}  // namespace etak
