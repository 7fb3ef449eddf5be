// SPDX-License-Identifier: Apache-2.0
#include "core/render/typed.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/ascii.h"
#include "core/base/text/edit_distance.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/fresnel/fresnel.h"
#include "core/material/appearance.h"
#include "core/material/f0.h"
#include "core/material/optics/optics_class.h"
#include "core/material/quality.h"
#include "core/render/reference.h"

namespace etak {
namespace {

constexpr double most_typed_f0 = 2;

}  // namespace

std::vector<double> typed_numbers(std::string_view text) {
  std::vector<double> out;
  for (;;) {
    const std::size_t comma = text.find(',');
    if (double value = 0; parse_number(trimmed(text.substr(0, comma), " "), value))
      out.push_back(value);
    else
      return {};
    if (comma == text.npos) return out;
    text.remove_prefix(comma + 1);
  }
}

LinearRgb typed_color(const std::string& place, std::string_view text) {
  if (text.starts_with('#')) return srgb_decode(parse_hex(text));
  const std::vector<double> out = typed_numbers(text);
  if (out.empty()) throw Error::at(place, printable(text), "one number, three with ',' between, or #rrggbb");
  if (out.size() == 1) return {out[0], out[0], out[0]};
  if (out.size() != 3)
    throw Error::at(place, std::to_string(out.size()) + " numbers", "one or three, or #rrggbb");
  return {out[0], out[1], out[2]};
}

LinearRgb typed_share(const std::string& place, std::string_view text) {
  const LinearRgb out = typed_color(place, text);
  for (const double value : vec(out))
    if (!(value >= 0 && value <= 1)) throw Error::at(place, number(value, 6), "0 to 1");
  return out;
}

SurfaceValues typed_surface(const std::vector<std::string>& words, const SurfaceWishes& wishes) {
  if (wishes.compute != F0Settings{})
    throw Error::at(words.front(), "beside an option that says how F0 is computed", "a material");
  SurfaceValues surface;
  surface.gloss = wishes.gloss.value_or(surface.gloss);
  surface.opacity = wishes.opacity.value_or(1);
  surface.diffuse = wishes.diffuse;
  bool has_f0 = false, has_f82 = false, has_index = false;
  std::optional<double> gloss, roughness;
  for (const std::string& each : words) {
    const std::size_t equals = each.find('=');
    if (equals == each.npos)
      throw Error::at(printable(each), "is no NAME=NUMBER like the others", "one material, or numbers only");
    const std::string name = each.substr(0, equals);
    const Vec3 value = vec(typed_color(name, std::string_view(each).substr(equals + 1)));
    // F0 of the library is above 1 where a colour lies outside of sRGB, and may be given so.
    const auto at_most = [&](double most) {
      for (const double v : value)
        if (!(v >= 0 && v <= most)) throw Error::at(name, number(v, 6), "0 to " + number(most, 3));
    };
    if (name == "f0") {
      at_most(most_typed_f0);
      surface.f0 = value;
      has_f0 = true;
    } else if (name == "f82") {
      at_most(most_typed_f0);
      surface.f82 = value;
      has_f82 = true;
    } else if (name == "n" || name == "k") {
      (name == "n" ? surface.n : surface.k) = value;
      has_index = true;
    } else if (name == "diffuse") {
      at_most(1);
      surface.diffuse = value;
    } else if (name == "gloss" || name == "roughness") {
      if (!(value[0] >= 0 && value[0] <= 1)) throw Error::at(name, number(value[0], 6), "0 to 1");
      (name == "gloss" ? gloss : roughness) = value[0];
    } else if (name == "opacity") {
      surface.opacity = value[0];
    } else {
      throw Error::at(printable(name), "is nothing of a surface",
                      "f0, f82, n, k, diffuse, gloss, roughness or opacity");
    }
  }
  if (gloss && roughness) throw Error::at("roughness", "given beside gloss", "one of the two");
  if (const std::optional<Gloss> given = given_gloss(gloss, roughness)) surface.gloss = *given;
  if (has_index && (has_f0 || has_f82)) throw Error::at("n, k", "given beside f0 or f82", "one of the two");
  if (has_index) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(surface.n[c] > 0 && surface.n[c] <= 1e4))
        throw Error::at("n", number(surface.n[c], 6), "above 0, at most 1e4");
      if (!(surface.k[c] >= 0 && surface.k[c] <= 1e6))
        throw Error::at("k", number(surface.k[c], 6), "0 to 1e6");
      surface.f0[c] = f64::f0(surface.n[c], surface.k[c]);
      surface.f82[c] = f64::fresnel_exact(surface.n[c], surface.k[c], f82_cosine);
    }
    return surface;
  }
  if (has_f82)
    solve_index(surface);
  else
    complete_from_f0(surface);
  return surface;
}

std::vector<std::pair<std::string, double>> typed_set(const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, double>> out;
  for (const std::string& each : texts) {
    const std::size_t equals = each.find('=');
    double value = 0;
    if (equals == each.npos || equals == 0 || !parse_number(std::string_view(each).substr(equals + 1), value))
      throw Error::at(setting("set"), printable(each), "NAME=NUMBER, or NAME.r=NUMBER for a channel");
    out.emplace_back(each.substr(0, equals), value);
  }
  return out;
}

const Model* model_named(const std::string& option, const std::string& id, std::string_view standard) {
  if (id == "none") return nullptr;
  if (const Model* model = find_model(id.empty() ? standard : std::string_view(id))) return model;
  for (const Term& each : terms())
    if (each.id == id)
      throw Error::at(option, printable(id) + ", which is one term of a model",
                      "microfacet:D,F,V with three terms of etak models, or a model");
  std::vector<std::string> ids;
  for (const Model& each : models()) ids.emplace_back(each.id);
  throw Error::at(option, printable(id), "a model that etak models lists, or none" + did_you_mean(id, ids));
}

std::string layers_remark(const Model& asked, const Model& drawn, const std::vector<double>& values,
                          const FresnelCurve& curve) {
  if (drawn.fresnel != nullptr && drawn.fresnel->id == "curve") {
    std::string out = curve_note(curve);
    if (&asked != &drawn)
      out += "; the model is " + std::string(drawn.id) + " in place of " + std::string(asked.id);
    return out;
  }
  std::string out = std::string(drawn.id) + " has an F of its own, which is not that of the layers";
  const std::optional<Lobe> lobe = lobe_of(drawn, values);
  if (!lobe) return out;
  // Light and viewer on both sides of the normal: what is left of the lobe with F = 1 is F.
  const auto own = [&](double cosine) {
    const double c = std::max(cosine, 1e-3), s = std::sqrt((1 - c) * (1 + c));
    const Directions d{s, 0, c, -s, 0, c};
    double whole[3], bare[3];
    drawn.f64(d, values.data(), whole);
    lobe->model->f64(d, lobe->values.data(), bare);
    return Vec3{whole[0] / bare[0], whole[1] / bare[1], whole[2] / bare[2]};
  };
  const FresnelDifference off =
      fresnel_difference(own, [&](double cosine) { return curve.at(std::max(cosine, 1e-3)); });
  return out + ": off by up to " + number(off.de2000, 2) + " (CIEDE2000), at " + number(off.at_deg, 3) +
         " degrees; a model of three terms has theirs";
}

std::string clamped_remark(const ClampedValue& value) {
  return value.name + " is " + number(value.wanted, 6) + ", taken as " + number(value.used, 6);
}

SurfaceValues surface_of(const Material& material, const Dataset& dataset, const SurfaceWishes& wishes,
                         const F0Options& options, std::vector<std::string>& remarks) {
  if (std::string remark = class_remark(material); !remark.empty())
    remarks.push_back(material.id + ": " + remark);
  const bool dielectric = optical_kind(material.material_class) == "dielectric";
  const Clarity body = clarity(material, dataset);
  const bool black = wishes.diffuse == Vec3{0, 0, 0}, clear = body.clear && black;
  Gloss gloss = wishes.gloss.value_or(1.0);
  if (!wishes.gloss) {
    const DefaultGloss standard = default_gloss(material, clear);
    // Where the default is a perfect mirror, the picture takes the highest gloss instead: in a mirror the
    // lights are points that no pixel hits.
    gloss = Gloss(double{standard.gloss});
    remarks.push_back(default_gloss_remark(standard) +
                      (standard.gloss.held()
                           ? "; drawn with " + roughness_text(gloss) + ", in which the lights can be seen"
                           : ""));
  }
  F0Settings settings = wishes.compute;
  const F0Result result = solve_averaged(settings.axis_average, F0Solver(options), material, dataset);
  SurfaceValues out = surface_of(material, dataset, result, wishes.diffuse, gloss, options);
  // The reference would draw n and k as they are: of one axis, in air, under D65.
  settings.axis_average = settings.axis_average && !dataset.axis.empty();
  if (settings != F0Settings{}) out.optics.reset();
  out.opacity = wishes.opacity.value_or(clear ? 0 : 1);
  if (clear && !wishes.opacity)
    remarks.push_back("the body of " + material.id + " is clear (" + body.reason +
                      "): what is behind it is seen through it; " + setting("opacity") +
                      " 1 draws its surface alone");
  if (dielectric && !body.clear && black) remarks.push_back(material.id + ": " + black_body_remark(body));
  if (!dielectric && !black)
    remarks.push_back(material.id + " is a " + std::string(optical_kind(material.material_class)) + ": " +
                      setting("diffuse") + " is not used");
  if (!gives_f0(material.material_class))
    remarks.push_back(total_reflectance_remark({to_rgb(out.diffuse), to_rgb(out.f0)}));
  return out;
}

}  // namespace etak
