// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/engine_values.h"

#include "core/base/error.h"
#include "core/exchange/export_coat.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

constexpr const TargetRow* rows[] = {
#define ETAK_TARGET(name) &target_##name,
#include "core/exchange/targets/targets.inc"
#undef ETAK_TARGET
};

// How a target takes an emission: as one colour, or as one of at most 1 and a strength.
struct EmissionField {
  std::string_view target;
  const char* color;
  const char* strength;  // null: there is none
  std::string (*text)(const LinearRgb&);
};
constexpr EmissionField emission_fields[] = {
    {"linear", "emission", nullptr, plain_text},
    {"unreal", "Emissive Color", nullptr, unreal_text},
    {"unreal-substrate", "Emissive Color", nullptr, unreal_text},
    {"unity-metallic", "Emission", "Emission intensity", hex_text},
    {"unity-specular", "Emission", "Emission intensity", hex_text},
    {"unity-hdrp", "Emission Color", "Emission Intensity", hex_text},
    {"blender", "Emission Color", "Emission Strength", blender_text},
    {"filament", "emissive", nullptr, plain_text},
    {"openpbr", "emission_color", "emission_luminance", plain_text},
    {"standard-surface", "emission_color", "emission", plain_text},
    {"godot", "emission", "emission_energy_multiplier", godot_text},
    {"threejs", "emissive", "emissiveIntensity", threejs_text},
    {"usd", "emissiveColor", nullptr, plain_text},
    {"gltf-pbr", "emissive", "emissive_strength", plain_text},
    {"gltf", "emissiveFactor", "KHR_materials_emissive_strength.emissiveStrength", plain_text},
    {"gltf-specular-glossiness", "emissiveFactor", "KHR_materials_emissive_strength.emissiveStrength",
     plain_text}};

void add_emission(const TargetJob& j) {
  const LinearRgb& emission = j.s.emission;
  if (emission == LinearRgb{}) return;
  for (const EmissionField& each : emission_fields) {
    if (each.target != j.out.target) continue;
    if (each.strength == nullptr) return j.add(each.color, emission, each.text);
    const auto [color, strength] = emission_parts(emission);
    j.add(each.color, color, each.text);
    // OpenPBR's luminance and Standard Surface's emission are 0 where nothing is said; the strength of the others is 1.
    if (strength != 1 || each.target == "openpbr" || each.target == "standard-surface")
      j.add(each.strength, strength);
    return;
  }
  j.note("no field for the emission " + plain_text(emission) + " (radiance, linear)");
}

void write_target(const EngineTarget& target, const TargetJob& job) {
  for (const TargetRow* row : rows)
    if (row->target.id == target.id) row->write(job);
}

// The fields that a target has with one set of the film's numbers.
EngineFilm::Side film_side(const EngineTarget& target, ExportSurface surface, ExportFilm::Choice choice,
                           Fit fit) {
  surface.film->choice = choice;
  EngineValues values;
  values.target = target.id;
  write_target(target, {surface, fit, values});
  return {std::move(values.fields), surface.film->values(target.film_form(surface.kind)).error};
}

void tell_film(const EngineTarget& target, const ExportSurface& surface, Fit fit, EngineValues& out) {
  const std::string_view form = target.film_form(surface.kind);
  if (form.empty()) {
    out.notes.emplace_back("no film is written: F0 and F82 are those of the whole");
    return;
  }
  const FilmInForm& in = *surface.film->fits->in(form);
  EngineFilm& film = out.film.emplace();
  if (in.honest) film.honest = film_side(target, surface, ExportFilm::Choice::honest, fit);
  film.fitted = film_side(target, surface, ExportFilm::Choice::fitted, fit);
  film.use_honest = in.use_honest();
  film.advice = in.advice();
  if (!in.note.empty()) out.notes.push_back(in.note);
  out.error = in.used().error;
  out.error_reason.clear();
  out.notes.push_back(film.advice);
}

}  // namespace

std::span<const EngineTarget> engine_targets() {
  static const std::vector<EngineTarget> targets = [] {
    std::vector<EngineTarget> out;
    for (const TargetRow* row : rows) out.push_back(row->target);
    return out;
  }();
  return targets;
}

const EngineTarget* engine_target(std::string_view id) {
  for (const EngineTarget& target : engine_targets())
    if (target.id == id) return &target;
  return nullptr;
}

EngineValues engine_values(const EngineTarget& target, const ExportSurface& surface, Fit fit) {
  validate(surface);
  if (surface.space != RgbSpace::srgb)
    throw Error::at(surface.id, "colours in " + std::string(name(surface.space)), "linear sRGB");
  EngineValues out;
  out.target = target.id;
  const bool whole = surface.coat && !target.has_coat;
  const ExportSurface used = whole ? as_whole(surface) : surface;
  if (whole)
    out.notes.push_back("no field for the coat " + surface.coat->label +
                        ": F0 and the edge are those of the base with its coat");
  const TargetJob job{used, fit, out};
  write_target(target, job);
  add_emission(job);
  for (const TargetRow* row : rows)
    if (row->target.id == target.id && row->body != nullptr) out.body = row->body(used, out);
  if (surface.film) tell_film(target, surface, fit, out);
  if (!out.error && out.error_reason.empty()) out.error_reason = target.unstated;
  return out;
}

std::string body_text(const EngineValues& values) {
  if (!values.body.empty()) return values.body;
  if (values.fields.size() == 1) return values.fields.front().text;
  std::string out;
  for (const EngineField& field : values.fields) out += field.name + ": " + field.text + '\n';
  return out;
}

std::string copy_text(const EngineValues& values) {
  const EngineTarget& target = *engine_target(values.target);
  return std::string(target.opens) + body_text(values) + std::string(target.closes);
}

}  // namespace etak
