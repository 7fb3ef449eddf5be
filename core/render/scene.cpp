// SPDX-License-Identifier: Apache-2.0
#include "core/render/scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/fresnel/fresnel.h"
#include "core/image/image.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

constexpr std::array<char, 3> channel_letters{'r', 'g', 'b'};

// The value of a parameter for a surface; the parameter's default where the surface does not have that
// quantity.
Vec3 value_of(const Parameter& parameter, const SurfaceValues& surface) {
  const auto all = [](double value) { return Vec3{value, value, value}; };
  switch (parameter.role) {
    case Role::diffuse:
      return surface.diffuse;
    case Role::f0:
      return surface.f0;
    case Role::f82: {
      if (parameter.name.find("tint") == std::string_view::npos) return surface.f82;
      Vec3 tint{};
      for (std::size_t c = 0; c < 3; ++c)
        tint[c] = surface.f82[c] / f64::f_schlick(surface.f0[c], f82_cosine);
      return tint;
    }
    case Role::n:
      return surface.n;
    case Role::k:
      return surface.k;
    case Role::gloss:
      return all(surface.gloss);
    case Role::alpha:
      return all(surface.gloss.alpha());
    case Role::exponent:
      return all(surface.gloss.exponent());
    case Role::curve:  // model_values() knows which colour it is
    case Role::other:
      break;
  }
  return all(parameter.initial);
}

std::string range_text(const Parameter& parameter) {
  return number(parameter.min, 6) + " to " + number(parameter.max, 6);
}

// Sets the numbers of the parameter "K" or of its channel "K.r". False when the model has no parameter of
// that name.
bool apply(const Model& model, const std::string& name, double value, std::vector<double>& values) {
  std::size_t at = 0;
  for (const Parameter& parameter : model.parameters) {
    const std::size_t count = parameter.color ? 3 : 1;
    const bool whole = name == parameter.name;
    for (std::size_t c = 0; c < count; ++c) {
      const bool channel = parameter.color && name == std::string(parameter.name) + '.' + channel_letters[c];
      if (!whole && !channel) continue;
      if (!(value >= parameter.min && value <= parameter.max))
        throw Error::at(name + " of model " + std::string(model.id), number(value, 6), range_text(parameter));
      values[at + c] = value;
      if (channel) return true;
    }
    if (whole) return true;
    at += count;
  }
  return false;
}

std::string parameter_names(const Model& model) {
  const std::string out = joined(model.parameters, ", ", &Parameter::name);
  return out.empty() ? "none" : out;
}

void require(bool good, const char* what, double value, const char* expected) {
  if (!good) throw Error::at(what, number(value, 6), expected);
}

void require_color(const Vec3& color, const char* what) {
  for (const double value : color) require(std::isfinite(value), what, value, "three finite numbers");
}

void require_values(const Model* model, const std::vector<double>& values) {
  if (model == nullptr) return;
  const std::string what = "parameters of model " + std::string(model->id);
  if (values.size() != model->value_count())
    throw Error::at(what, std::to_string(values.size()) + " numbers", std::to_string(model->value_count()));
  for (const double value : values) require(std::isfinite(value), what.c_str(), value, "finite numbers");
}

}  // namespace

std::vector<double> model_values(const Model& model, const SurfaceValues& surface,
                                 const std::vector<std::pair<std::string, double>>& overrides,
                                 std::vector<ClampedValue>* clamped) {
  std::vector<double> values;
  std::optional<FresnelCurve> curve;
  std::size_t of_curve = 0;
  for (const Parameter& parameter : model.parameters) {
    Vec3 wanted = value_of(parameter, surface);
    if (parameter.role == Role::curve) {
      if (!curve) curve = curve_of(surface);
      wanted = curve->colors[of_curve++];
    }
    for (std::size_t c = 0; c < (parameter.color ? 3u : 1u); ++c) {
      // Colours outside of a display's gamut (gold's red is 1.04) are not clamped, because the models
      // evaluate them.
      const bool color =
          parameter.role == Role::f0 || parameter.role == Role::diffuse || parameter.role == Role::curve;
      const double used = color ? wanted[c] : std::clamp(wanted[c], parameter.min, parameter.max);
      if (used != wanted[c] && clamped != nullptr) {
        std::string name(parameter.name);
        if (parameter.color) name = name + '.' + channel_letters[c];
        clamped->push_back({std::move(name), wanted[c], used});
      }
      values.push_back(used);
    }
  }
  for (const auto& [name, value] : overrides)
    if (!apply(model, name, value, values))
      throw Error::at("model " + std::string(model.id), "has no parameter " + printable(name),
                      parameter_names(model));
  return values;
}

std::vector<double> seen_specular_values(const Scene& scene) {
  std::vector<double> out = scene.specular_values;
  if (scene.specular == nullptr || scene.specular->kind != ModelKind::combined) return out;
  std::size_t at = 0;
  for (const Parameter& each : scene.specular->parameters) {
    const std::size_t count = each.color ? 3 : 1;
    for (std::size_t i = at; each.role == Role::diffuse && i < at + count; ++i)
      out[i] *= scene.surface.opacity;
    at += count;
  }
  return out;
}

bool body_is_black(const Model& model, const std::vector<double>& values) {
  bool any = false;
  std::size_t at = 0;
  for (const Parameter& parameter : model.parameters)
    for (std::size_t c = 0; c < (parameter.color ? 3u : 1u); ++c, ++at)
      if (parameter.role == Role::diffuse) {
        any = true;
        if (at < values.size() && values[at] != 0) return false;
      }
  return any;
}

namespace {

bool has_parameter(const Model* model, std::string_view name) {
  if (model == nullptr) return false;
  for (const Parameter& each : model->parameters)
    if (name.substr(0, name.find('.')) == each.name) return true;
  return false;
}

// Sets the colours and the gloss of the surface to those of the model, because hemispheres and environment
// use the surface's.
void take_set(const Model& model, const std::vector<double>& values, SurfaceValues& surface) {
  std::size_t at = 0;
  for (const Parameter& each : model.parameters) {
    Vec3* color = each.role == Role::diffuse ? &surface.diffuse
                  : each.role == Role::f0    ? &surface.f0
                                             : nullptr;
    for (std::size_t c = 0; color != nullptr && c < 3; ++c) (*color)[c] = values[at + (each.color ? c : 0)];
    if (each.role == Role::gloss) surface.gloss = values[at];
    at += each.color ? 3 : 1;
  }
}

}  // namespace

const Model* drawn_model(const Model* model, const SurfaceValues& surface) {
  if (model == nullptr || !surface.curve || (model->fresnel == nullptr && model->id != default_specular))
    return model;
  const std::string d(model->fresnel == nullptr ? "ggx" : model->distribution->id),
      v(model->fresnel == nullptr ? "smith-ggx-height" : model->visibility->id);
  return find_model("microfacet:" + d + ",curve," + v);
}

FittedModels fit_models(const Model* specular, const Model* diffuse,
                        const std::vector<std::pair<std::string, double>>& overrides,
                        SurfaceValues& surface) {
  specular = drawn_model(specular, surface);
  if (diffuse != nullptr && diffuse->kind != ModelKind::diffuse)
    throw Error::at("diffuse model", std::string(diffuse->id) + " is no diffuse model",
                    "lambert, oren-nayar, ...");
  if (specular != nullptr && specular->kind == ModelKind::diffuse)
    throw Error::at("specular model", std::string(specular->id) + " is a diffuse model",
                    "it as the diffuse one");
  FittedModels out;
  out.specular = specular;
  if (specular == nullptr || specular->kind != ModelKind::combined) out.diffuse = diffuse;
  std::vector<std::pair<std::string, double>> for_specular, for_diffuse;
  for (const auto& value : overrides) {
    const bool to_diffuse = specular == nullptr || (!has_parameter(specular, value.first) &&
                                                    has_parameter(out.diffuse, value.first));
    (to_diffuse ? for_diffuse : for_specular).push_back(value);
  }
  if (specular != nullptr) {
    out.specular_values = model_values(*specular, surface, for_specular, &out.clamped);
    if (!for_specular.empty()) take_set(*specular, out.specular_values, surface);
  }
  if (out.diffuse != nullptr) {
    out.diffuse_values = model_values(*out.diffuse, surface, for_diffuse, &out.clamped);
    if (!for_diffuse.empty()) take_set(*out.diffuse, out.diffuse_values, surface);
  } else if (!for_diffuse.empty()) {
    throw Error::at("models", "none has a parameter " + printable(for_diffuse.front().first),
                    "a parameter of a model in use");
  }
  return out;
}

bool is_clear_ball(const Scene& scene) {
  return scene.shape == Shape::sphere && scene.mesh == nullptr && !scene.textured().values() &&
         scene.surface.passing.has_value() && scene.surface.opacity < 1;
}

bool is_seen_through(const Scene& scene) {
  return scene.textured().values() || scene.surface.opacity < 1;
}

void validate(const Scene& scene, bool meshes_drawn) {
  if (scene.mesh != nullptr && !meshes_drawn)
    throw Error::at("scene", "a mesh", "a sphere or a quad, which alone the reference and GL draw");
  for (const int side : {scene.width, scene.height})
    require(side >= 1 && side <= max_image_side, "size", side, "1 to 16384 pixels on a side");
  if (scene.specular == nullptr && scene.diffuse == nullptr)
    throw Error::at("scene", "has no model", "a specular or a diffuse model");
  if (scene.specular != nullptr && scene.specular->kind == ModelKind::combined && scene.diffuse != nullptr)
    throw Error::at(
        "scene",
        "a diffuse model beside " + std::string(scene.specular->id) + ", which has a diffuse part of its own",
        "one of them");
  const SurfaceValues& surface = scene.surface;
  require_color(surface.diffuse, "diffuse colour");
  require_color(surface.f0, "F0");
  require(surface.gloss >= 0 && surface.gloss <= 1, "gloss", surface.gloss, "0 to 1");
  require(surface.opacity >= 0 && surface.opacity <= 1, "opacity", surface.opacity, "0 to 1");
  for (const double each : surface.emission)
    require(each >= 0 && std::isfinite(each), "emission", each, "a finite number of at least 0");
  require(surface.occlusion >= 0 && surface.occlusion <= 1, "occlusion", surface.occlusion, "0 to 1");
  for (std::size_t c = 0; c < 3; ++c) {
    require(surface.n[c] > 0 && surface.n[c] <= 1e4, "n", surface.n[c], "above 0, at most 1e4");
    require(surface.k[c] >= 0 && surface.k[c] <= 1e6, "k", surface.k[c], "0 to 1e6");
  }
  if (surface.passing)
    for (const double each : *surface.passing)
      require(each > 0 && each <= 1, "share of light that passes", each, "above 0, at most 1");
  require_values(scene.specular, scene.specular_values);
  require_values(scene.diffuse, scene.diffuse_values);
  require_color(scene.background, "background");
  require(scene.backdrop.blur >= 0 && scene.backdrop.blur <= 1, "blur", scene.backdrop.blur, "0 to 1");
  require(scene.exposure >= 0 && std::isfinite(scene.exposure), "exposure", scene.exposure,
          "a finite factor of at least 0");
  require(scene.field_of_view_deg >= 1 && scene.field_of_view_deg <= 170, "field of view",
          scene.field_of_view_deg, "1 to 170 degrees");
  if (scene.view) {
    const View& view = *scene.view;
    require(std::abs(view.rise_deg) <= 90, "camera's height", view.rise_deg, "-90 to 90 degrees");
    require(view.zoom >= 1e-3 && view.zoom <= 1e3, "zoom", view.zoom, "0.001 to 1000");
    for (const double value : {view.turn_deg, view.pan_x, view.pan_y})
      require(std::abs(value) <= 1e6, "view", value, "finite numbers");
  }
  require(std::isfinite(scene.environment_turn_deg), "environment's turn", scene.environment_turn_deg,
          "a finite angle");
  const SurfaceTextures::Quantities has = scene.textured();
  if (scene.textures)
    for (const auto& [each, needed] : {std::pair(&scene.textures->body, has.diffuse || has.opacity),
                                       std::pair(&scene.textures->gloss, has.f0 || has.gloss),
                                       std::pair(&scene.textures->emission, has.emission || has.occlusion)})
      if (needed && (each->channels != 4 || each->width < 1 || each->height < 1 ||
                     std::max(each->width, each->height) > max_scene_texture))
        throw Error::at("texture",
                        std::to_string(each->width) + " x " + std::to_string(each->height) + " pixels of " +
                            std::to_string(each->channels) + " channels",
                        "at most " + std::to_string(max_scene_texture) + " a side, four channels");
  validate(scene.lights, "lights");
}

}  // namespace etak
