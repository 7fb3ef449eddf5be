// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number.h"
#include "core/exchange/color_parts.h"
#include "core/exchange/color_text.h"
#include "core/exchange/engine_values.h"

namespace etak {

/// The input and output of a target, and the notes that all targets share.
struct TargetJob {
  const ExportSurface& s;
  Fit fit;
  EngineValues& out;

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

  LinearRgb fit_f0(const char* field, const char* reason) const {
    return fitted(s.f0, fit, 1, s.space, field, reason, out.changes);
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

/// A target and the function that writes its fields, changes and notes.
struct TargetRow {
  EngineTarget target;
  void (*write)(const TargetJob&);
};

/// The rows of the table, in the files of this folder.
#define ETAK_TARGET(name) extern const TargetRow target_##name;
#include "core/exchange/targets/targets.inc"
#undef ETAK_TARGET

}  // namespace etak
