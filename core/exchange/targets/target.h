// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number.h"
#include "core/exchange/color_parts.h"
#include "core/exchange/color_text.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/export_coat.h"
#include "core/exchange/material_x.h"
#include "core/fresnel/fresnel.h"
#include "core/math/functions.h"

namespace etak {

/// The input and output of a target, and the notes that all targets share.
///   coat   that the target draws over what it shows; none: what it shows is all
struct TargetJob {
  const ExportSurface& s;
  Fit fit;
  EngineValues& out;
  std::optional<TargetCoat> coat = {};

  /// The job of what lies below the surface's coat, where it has one, as the target draws that.
  TargetJob below(const TargetCoat& over) const { return s.coat ? TargetJob{s, fit, out, over} : *this; }

  bool metal() const { return s.kind == SurfaceKind::metal; }
  bool black_body() const { return s.diffuse == LinearRgb{}; }
  bool clear() const { return s.clear.has_value(); }
  double roughness() const { return s.gloss.roughness(); }

  void add(const char* field, std::vector<double> values, std::string text) const {
    out.fields.push_back({field, std::move(values), std::move(text)});
  }
  void add(const char* field, double value) const { add(field, {value}, number(value, digits)); }
  void add(const char* field, const LinearRgb& c, std::string (*text)(const LinearRgb&)) const {
    add(field, list(c), text(c));
  }
  // MaterialX's roughness: alpha along both axes.
  void add_alpha(const char* field) const {
    const std::string alpha = number(s.gloss.alpha(), digits);
    add(field, {s.gloss.alpha()}, alpha + ", " + alpha);
  }
  void opacity(const char* field) const {
    if (s.opacity < 1) add(field, s.opacity);
  }
  void note(std::string text) const { out.notes.push_back(std::move(text)); }
  // The index of a clear body: that of the luminance of F0.
  double index() const {
    return s.ior.value_or(ior_of_f0(std::clamp(luminance(s.f0, s.space), 0.0, largest_dielectric_f0)));
  }
  std::string index_text() const { return "index " + number(index(), 5); }
  // The note about absorption over a depth, for targets without a field for it.
  void note_absorption(const char* where) const {
    if (clear() && s.clear->depth_m > 0)
      note("light through " + number(s.clear->depth_m, 3) + " m of it becomes " + plain_text(s.clear->color) +
           " (linear): " + where);
  }
  void note_no_transmission(const char* what) const {
    if (clear()) note("the body is clear, which " + std::string(what) + ": " + index_text());
  }
  // The diffuse colour of a dielectric for targets that take the surface's reflectance off it. Typed colours
  // are passed on unchanged; a measured total must come out as it was measured.
  LinearRgb layered_body() const { return layered_diffuse(s); }

  /// Tells by what F over the angle the target draws the values, below its coat, which gives their error.
  ///   f   linear sRGB at a cosine of incidence above 0
  void shows(const std::function<Vec3(double cosine)>& f) const {
    if (!s.seen) {
      out.error_reason = s.unseen;
      return;
    }
    // Rounded far below what is seen, so that no machine's rounding shows.
    out.error = film_error([&](double c) { return coat ? coat->over(f(c), c) : f(c); }, *s.seen);
    for (double* const each : {&out.error->mean, &out.error->largest, &out.error->normal})
      *each = std::round(*each * 1e6) / 1e6;
  }
  /// Schlick's curve from f0 to f90, in each channel.
  void shows_schlick(const LinearRgb& f0, double f90 = 1) const {
    shows([&](double cosine) {
      Vec3 f = vec(f0);
      for (double& channel : f) channel += (f90 - channel) * math::pow(1 - cosine, 5);
      return f;
    });
  }
  /// F with an n and k of each channel.
  ///   f   of n, k and the cosine of incidence: Fresnel's equations, or what a renderer has in their place
  void shows_conductor(const LinearRgb& n, const LinearRgb& k,
                       double (*f)(double n, double k, double cosine) = f64::fresnel_exact) const {
    shows([&](double cosine) { return Vec3{f(n.r, k.r, cosine), f(n.g, k.g, cosine), f(n.b, k.b, cosine)}; });
  }
  /// Fresnel's equations of an index, times a colour.
  void shows_dielectric(double ior, const LinearRgb& tint = {1, 1, 1}) const {
    shows([&](double cosine) { return vec(scaled(tint, f64::fresnel_exact(ior, 0, cosine))); });
  }
  /// The F82 tint of Kutz and others.
  void shows_f82(const LinearRgb& f0, const LinearRgb& tint) const {
    shows([&](double cosine) {
      return Vec3{f64::f_f82_tint(f0.r, tint.r, cosine), f64::f_f82_tint(f0.g, tint.g, cosine),
                  f64::f_f82_tint(f0.b, tint.b, cosine)};
    });
  }

  LinearRgb fit_f0(const char* field, const char* reason) const {
    return fitted(s.f0, {fit, 1, s.space}, field, reason, out.changes);
  }
  // The Change of a known edge that the target's own curve replaces.
  void schlick_edge(const LinearRgb& f0_used) const {
    if (s.f82)
      note_change(out.changes, "F82", list(*s.f82), list(schlick82(f0_used)), "schlick",
                  "no edge colour: the edge follows from F0 alone");
  }
  // A dielectric's F0 as one number.
  double one_f0(const char* reason) const {
    const double y = luminance(s.f0, s.space);
    note_change(out.changes, "F0", list(s.f0), list(grey(y)), "luminance", reason);
    return y;
  }
};

/// The F90 of Filament, Godot and HDRP: it fades below an F0 of 0.02, which they take as shadow.
inline double faded_f90(const LinearRgb& f0) {
  return std::clamp(50 * 0.33 * (f0.r + f0.g + f0.b), 0.0, 1.0);
}

/// Two colours that stand for n and k (Gulbrandsen 2014), and the n and k that they stand for.
struct ArtisticIndex {
  LinearRgb reflectivity, edge_color, n, k;
};
/// `field` names the reflectivity in a Change.
ArtisticIndex artistic_index(const TargetJob& job, const char* field);

/// Why constants and colours have no error.
inline constexpr std::string_view one_angle = "a colour for one angle, without a formula of its own";
inline constexpr std::string_view own_formula = "constants, which a shader of one's own uses";

/// A target and the function that writes its fields, changes and notes.
///   body   the text of a material, from its fields; null: as copy_text() makes it
struct TargetRow {
  EngineTarget target;
  void (*write)(const TargetJob&);
  std::string (*body)(const ExportSurface& surface, const EngineValues& values) = nullptr;
};

/// The rows of the table, in the files of this folder.
#define ETAK_TARGET(name) extern const TargetRow target_##name;
#include "core/exchange/targets/targets.inc"
#undef ETAK_TARGET

}  // namespace etak
