// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/export_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/color/aces.h"
#include "core/exchange/export_values.h"
#include "core/fresnel/fresnel.h"
#include "core/material/appearance.h"
#include "core/material/optics/optics_class.h"
#include "core/material/quality.h"
#include "core/material/seen_stack.h"

namespace etak {
namespace {

// Notes about the data, for the user of the values.
void note_quality(ExportSurface& out, const Material& material, const Dataset& dataset) {
  const Flags flags = quality_flags(material, dataset);
  for (const Flag flag : {Flag::computed, Flag::sparse})
    if (flags.has(flag)) out.notes.push_back(std::string(name(flag)) + ": " + std::string(meaning(flag)));
  if (flags.has(Flag::doubtful)) out.notes.push_back("doubtful: " + doubt(material, dataset));
  out.source = material.id + "/" + dataset.id + " (" + quality_text(dataset.origin, flags) +
               "): " + one_line(dataset.citation);
}

// The XYZ of a white with chromaticity x, y and Y = 1.
Xyz white_of(RgbSpace space) {
  const double x = space == RgbSpace::acescg ? aces_white_x : 0.3127,
               y = space == RgbSpace::acescg ? aces_white_y : 0.3290;
  return {x / y, 1, (1 - x - y) / y};
}

// The measured total reflectance of a rough body, as its diffuse colour under a surface.
void take_total(const LinearRgb& measured, ExportSurface& out) {
  Changes changes;
  out.total = fitted(measured, {Fit::clamp, 1, out.space}, "total reflectance",
                     "light that is sent back is 0 to 1 of each channel", changes);
  for (const Change& change : changes) out.notes.push_back(one_line(change));
  const TotalReflectance parts = divided(*out.total);
  out.f0 = parts.f0;
  out.diffuse = parts.diffuse;
  out.notes.push_back(total_reflectance_remark(parts));
}

void take_clarity(const Material& material, const Clarity& body, ExportSurface& out) {
  if (!body.clear) {
    out.notes.push_back(black_body_remark(body));
    return;
  }
  out.clear = body.body;
  out.notes.push_back("the body is clear: " + body.reason);
  if (material.material_class == "gas")
    out.notes.emplace_back("a gas has no surface of its own: the index alone is of use");
}

// The exact F over the angle: the spectra of n and k, or of a stack, summed to colours at each angle.
void take_seen(const Dataset& dataset, const F0Options& options, ExportSurface& out) {
  const auto* constants = std::get_if<OpticalConstants>(&dataset.optics);
  if (options.space != RgbSpace::srgb || options.custom_space) {
    out.unseen = "errors are computed in linear sRGB";
    return;
  }
  if (const auto* stack = std::get_if<Stack>(&dataset.optics)) {
    const SeenStack seen(*stack, options);
    out.seen = film_truth(std::cref(seen));
  } else if (constants != nullptr) {
    const Stack bare{dataset.id, {{dataset.id, dataset.id, {}, *constants}}, {}, 0};
    const SeenStack seen(bare, options);
    out.seen = film_truth(std::cref(seen));
    const FilmSpectra& grid = seen.spectra();
    for (std::size_t i = 0; i < grid.wavelength_nm.size(); ++i)
      if (std::fmod(grid.wavelength_nm[i], 5) == 0)
        out.spectrum.push_back(
            {grid.wavelength_nm[i], grid.base.n[i], grid.base.k.empty() ? 0 : grid.base.k[i]});
  } else {
    out.unseen = "the data are reflectance at normal incidence";
  }
}

void take_film(const Stack& stack, const Material& material, const F0Options& options, ExportSurface& out) {
  out.film = ExportFilm{std::make_shared<FilmFits>(stack, film_base(material.material_class), options)};
  out.notes.push_back("F0 and F82 are those of " + stack.text + ", layers and base together");
  const FilmParameters& known = out.film->fits->known();
  for (const std::string& note : known.notes) out.notes.push_back(note);
  if (!known.no_honest.empty()) out.notes.push_back("films of renderers are fitted: " + known.no_honest);
}

std::string numbers(const std::vector<double>& values) {
  return joined(values, " ", [](double value) { return number(value, 4); });
}

}  // namespace

std::string_view name(SurfaceKind kind) {
  return kind == SurfaceKind::metal ? "metal" : "dielectric";
}

std::string_view name(Fit fit) {
  return fit == Fit::clamp ? "clamp" : "preserve-hue";
}

std::optional<Fit> fit_named(std::string_view text) {
  for (const Fit fit : {Fit::clamp, Fit::preserve_hue})
    if (text == name(fit)) return fit;
  return std::nullopt;
}

ExportSurface export_surface(const Material& material, const Dataset& dataset, const F0Options& options,
                             const F0Result& result, const LinearRgb& diffuse, std::optional<Gloss> gloss) {
  ExportSurface out;
  out.id = material.id;
  out.name = material.name;
  note_quality(out, material, dataset);
  out.space = options.space;
  if (result.flags.has(Flag::finer_than_grid))
    out.notes.push_back(std::string(name(Flag::finer_than_grid)) + ": " +
                        std::string(meaning(Flag::finer_than_grid)));
  if (std::string remark = class_remark(material); !remark.empty()) out.notes.push_back(std::move(remark));
  const std::string_view kind = optical_kind(material.material_class);
  if (material.class_by == ClassBy::nobody && result.luminance > most_assumed_f0)
    throw Error::at(
        material.id + "/" + dataset.id,
        "F0 " + number(result.luminance, 3) +
            " is too bright for a dielectric, no class is stated, and n and k at 550 nm do not tell it",
        setting("material-class") + " metal, semiconductor, surface, ...");
  if (kind == "surface") {
    take_total(result.linear, out);
    out.unseen = "a measured total tells no F over the angle";
  } else {
    out.kind = kind == "dielectric" ? SurfaceKind::dielectric : SurfaceKind::metal;
    out.f0 = result.linear;
    out.f82 = result.f82;
    if (out.kind == SurfaceKind::dielectric) out.diffuse = diffuse;
    if (const auto* stack = std::get_if<Stack>(&dataset.optics)) take_film(*stack, material, options, out);
    take_seen(dataset, options, out);
    if (!result.f82) out.notes.emplace_back("no edge is known: the data are reflectance at normal incidence");
    if (out.kind == SurfaceKind::dielectric && out.diffuse == LinearRgb{})
      take_clarity(material, clarity(material, dataset, options.space), out);
    if (options.outside.label != "vacuum") {
      out.notes.push_back("all values are against the outside medium " + options.outside.label);
      out.source += std::string(source_outside) + options.outside.label;
    }
  }
  const DefaultGloss standard = default_gloss(material, out.clear.has_value());
  if (!gloss) out.notes.push_back(default_gloss_remark(standard));
  out.gloss = gloss.value_or(standard.gloss);
  return out;
}

const FilmValues& ExportFilm::values(std::string_view form) const {
  const FilmInForm& found = *fits->in(form);
  if (choice == Choice::advised) return found.used();
  return choice == Choice::honest ? found.honest.value() : found.fitted;
}

SurfaceKind authored_kind(const LinearRgb& diffuse, const LinearRgb& f0) {
  return diffuse == LinearRgb{} && luminance(f0, RgbSpace::srgb) >= forbidden_zone_last
             ? SurfaceKind::metal
             : SurfaceKind::dielectric;
}

void validate(const ExportSurface& surface) {
  const auto in_range = [&](double value, const char* what) {
    if (!(value >= 0 && value <= 1))
      throw Error::at(surface.id, std::string(what) + " " + number(value, 6), "0 to 1");
  };
  in_range(surface.gloss, "gloss");
  in_range(surface.gloss.roughness(), "roughness");
  in_range(surface.opacity, "opacity");
  for (const double value : vec(surface.diffuse)) in_range(value, "diffuse");
  for (const double value : vec(surface.emission))
    if (!(value >= 0 && std::isfinite(value)))
      throw Error::at(surface.id, "emission " + number(value, 6), "a finite number of at least 0");
  for (const double value : vec(surface.f0))
    if (!std::isfinite(value)) throw Error::at(surface.id, "F0 " + number(value, 6), "a finite number");
  if (surface.f82)
    for (const double value : vec(*surface.f82))
      if (!std::isfinite(value)) throw Error::at(surface.id, "F82 " + number(value, 6), "a finite number");
}

EmissionParts emission_parts(const LinearRgb& emission) {
  const double strength = std::max({1.0, emission.r, emission.g, emission.b});
  return {{emission.r / strength, emission.g / strength, emission.b / strength}, strength};
}

double ior_of_f0(double f0) {
  const double root = std::sqrt(std::max(f0, 0.0));
  return (1 + root) / (1 - root);
}

double luminance(const LinearRgb& color, RgbSpace space) {
  if (space == RgbSpace::xyz) return color.g;
  return (rgb_to_xyz(primaries(space), white_of(space)) * vec(color))[1];
}

double Change::amount() const {
  double most = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) most = std::max(most, std::abs(used[i] - wanted[i]));
  return most;
}

std::string one_line(const Change& change) {
  return change.field + " " + numbers(change.wanted) + " -> " + numbers(change.used) + " (" + change.action +
         ", " + number(change.amount(), 3) + "): " + change.reason;
}

void note_change(Changes& changes, std::string_view field, std::vector<double> wanted,
                 std::vector<double> used, std::string_view action, std::string_view reason) {
  Change change{std::string(field), std::move(wanted), std::move(used), std::string(action),
                std::string(reason)};
  if (change.amount() > 1e-6) changes.push_back(std::move(change));
}

LinearRgb fitted(const LinearRgb& color, const ColorRange& range, std::string_view field,
                 std::string_view reason, Changes& changes) {
  Vec3 out = vec(color);
  if (range.fit == Fit::preserve_hue) {
    const double least = std::min({out[0], out[1], out[2]}), grey = luminance(color, range.space);
    if (least < 0 && grey > 0)
      for (double& channel : out) channel = grey + (channel - grey) * grey / (grey - least);
    const double largest = std::max({out[0], out[1], out[2]});
    if (largest > range.most)
      for (double& channel : out) channel *= range.most / largest;
  }
  // All of Fit::clamp; for preserve_hue only rounding errors and colours without luminance are left.
  for (double& channel : out) channel = std::clamp(channel, 0.0, range.most);
  const Vec3 wanted = vec(color);
  note_change(changes, field, {wanted.begin(), wanted.end()}, {out.begin(), out.end()}, name(range.fit),
              reason);
  return to_rgb(out);
}

double fitted(double value, double least, double most, std::string_view field, std::string_view reason,
              Changes& changes) {
  const double out = std::clamp(value, least, most);
  note_change(changes, field, {value}, {out}, "clamp", reason);
  return out;
}

LinearRgb schlick82(const LinearRgb& f0) {
  return {f64::f_schlick(f0.r, f82_cosine), f64::f_schlick(f0.g, f82_cosine),
          f64::f_schlick(f0.b, f82_cosine)};
}

LinearRgb tint82(const ExportSurface& surface, const LinearRgb& f0) {
  if (!surface.f82) return {1, 1, 1};
  const LinearRgb schlick = schlick82(f0);
  return {surface.f82->r / schlick.r, surface.f82->g / schlick.g, surface.f82->b / schlick.b};
}

}  // namespace etak
