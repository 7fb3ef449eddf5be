// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/scene.h"

#include <algorithm>
#include <cmath>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/fresnel/fresnel.h"
#include "core/light/area_lobes.h"
#include "core/material/appearance.h"
#include "core/material/names.h"
#include "core/material/optics/optics_class.h"
#include "core/material/quality.h"
#include "core/render/ambient/ambient.h"
#include "core/render/display.h"
#include "core/render/ground_bounce.h"

namespace etak::cli {
namespace {

using Overrides = std::vector<std::pair<std::string, double>>;

}  // namespace

bool is_typed(const SceneArguments& arguments) {
  return !arguments.subject.empty() && arguments.subject.front().find('=') != std::string::npos;
}

SubjectMaterial subject_material(SceneArguments& arguments, SceneNotes& notes) {
  InputNames names;
  names.names = arguments.subject;
  names.dataset = arguments.dataset;
  const std::vector<MaterialInput> inputs = find_inputs(names, arguments.library.when_asked(), 1);
  if (inputs.size() == 1 && inputs[0].kind == MaterialInput::Kind::failed) throw Error(inputs[0].path);
  if (inputs.size() != 1 || inputs[0].from_folder)
    throw Error::at(arguments.subject.front(), std::to_string(inputs.size()) + " inputs",
                    "one material, or one of its datasets");
  for (const std::string& each : alias_remarks(inputs)) notes.remarks.push_back(each);
  SubjectMaterial out{read_material(inputs[0], table_options(arguments.tables))};
  const Dataset& dataset = dataset_named(out.material, inputs[0].dataset, inputs[0].label());
  out.at = static_cast<std::size_t>(&dataset - out.material.datasets.data());
  notes.subject = out.material.id + "/" + dataset.id;
  return out;
}

SurfaceWishes surface_wishes(const SceneArguments& arguments) {
  SurfaceWishes out;
  if (!arguments.diffuse.empty()) out.diffuse = vec(typed_share("--diffuse", arguments.diffuse));
  out.gloss = given_gloss(arguments.rough);
  out.opacity = arguments.opacity;
  out.compute = arguments.compute;
  return out;
}

SurfaceValues subject_surface(SceneArguments& arguments, SceneNotes& notes) {
  if (arguments.subject.empty())
    throw Error::at("etak", "no material", "a material, or numbers such as f0=0.04");
  const SurfaceWishes wishes = surface_wishes(arguments);
  if (is_typed(arguments)) {
    notes.subject = joined(arguments.subject, " ");
    return typed_surface(arguments.subject, wishes);
  }
  const SubjectMaterial found = subject_material(arguments, notes);
  return surface_of(found.material, found.dataset(), wishes, f0_options(arguments.compute, arguments.library),
                    notes.remarks);
}

namespace {

// The number of lights of --lights N; none where --lights names a file or is not given. Throws Error.
std::optional<int> light_count(const std::string& text) {
  double count = 0;
  if (text.empty() || !parse_number(text, count)) return std::nullopt;
  if (!(count >= 0 && count <= 64 && count == std::floor(count)))
    throw Error::at("--lights", text, "0 to 64 directional lights, a file, or sources");
  return static_cast<int>(count);
}

std::pair<int, int> size_of(const std::string& text) {
  const std::size_t cross = text.find('x');
  double width = 0, height = 0;
  const bool good = parse_number(std::string_view(text).substr(0, cross), width) &&
                    (cross == text.npos || parse_number(std::string_view(text).substr(cross + 1), height));
  if (cross == text.npos) height = width;
  const auto fits = [](double side) {
    return side >= 1 && side <= max_image_side && side == std::floor(side);
  };
  if (!good || !fits(width) || !fits(height))
    throw Error::at("--size", printable(text),
                    "N or WIDTHxHEIGHT, 1 to " + std::to_string(max_image_side) + " pixels on a side");
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

void choose_models(Scene& scene, const std::string& specular, const std::string& diffuse,
                   const Overrides& set, std::vector<std::string>& remarks) {
  scene.specular = model_named("--model", specular, default_specular);
  scene.diffuse = model_named("--diffuse-model", diffuse, default_diffuse);
  if (scene.diffuse != nullptr && scene.diffuse->kind != ModelKind::diffuse)
    throw Error::at("--diffuse-model", std::string(scene.diffuse->id) + " is no diffuse model",
                    "lambert, oren-nayar, ...");
  if (scene.specular != nullptr && scene.specular->kind == ModelKind::diffuse)
    throw Error::at("--model", std::string(scene.specular->id) + " is a diffuse model",
                    "--diffuse-model for it");
  // A combined model has a diffuse part of its own.
  if (scene.specular != nullptr && scene.specular->kind == ModelKind::combined) {
    if (!diffuse.empty() && diffuse != "none")
      throw Error::at("--diffuse-model",
                      "model " + std::string(scene.specular->id) + " has a diffuse part of its own",
                      "no other one");
    scene.diffuse = nullptr;
  }
  FittedModels fitted = fit_models(scene.specular, scene.diffuse, set, scene.surface);
  if (scene.surface.curve && scene.specular != nullptr)
    remarks.push_back(
        layers_remark(*scene.specular, *fitted.specular, fitted.specular_values, *scene.surface.curve));
  scene.specular = fitted.specular;
  scene.specular_values = std::move(fitted.specular_values);
  scene.diffuse_values = std::move(fitted.diffuse_values);
  for (const ClampedValue& each : fitted.clamped) remarks.push_back(clamped_remark(each));
}

void tell_held_gloss(const Scene& scene, SceneNotes& notes) {
  if (!scene.surface.gloss.held()) return;
  std::string takers;
  const auto add = [&](std::string_view who) { takers += (takers.empty() ? "" : ", ") + std::string(who); };
  for (const Model* model : {scene.specular, scene.diffuse})
    if (model != nullptr)
      for (const Parameter& each : model->parameters)
        if (each.role == Role::gloss) add("model " + std::string(model->id));
  if (scene.lights.hemispheres && hemisphere_form(scene) != HemisphereForm::model)
    add("the light of the hemispheres");
  // The sharpest level of an environment is that of gloss 1.
  if (!scene.lights.environment.empty() && scene.surface.gloss >= 1) add("the light of the environment");
  if (!takers.empty()) notes.remarks.push_back(held_text(scene.surface.gloss) + " (" + takers + ")");
}

namespace {

// Adds remarks on how far area lights fit the model.
void tell_areas(const Scene& scene, std::vector<std::string>& remarks) {
  const bool any = std::ranges::any_of(scene.lights.lights, [](const Light& l) { return is_area(l.kind); });
  if (!any || scene.specular == nullptr) return;
  const AreaFit fit = area_fit(*scene.specular, scene.specular_values);
  // Below it the fits of Beckmann and Phong are off by 4 to 10 % under large lights.
  constexpr double least_alpha = 0.2;
  if (fit.own && area_family_name(fit.family) != "GGX" && fit.alpha < least_alpha)
    remarks.push_back(std::string(scene.specular->id) +
                      ": area lights of more than 20 degrees are off by up to 10 % at alpha " +
                      number(fit.alpha, 3) +
                      ", where the lobe is no transformed cosine; --reference samples them");
  if (!fit.own)
    remarks.push_back(std::string(scene.specular->id) + ": no fit of its lobe for area lights; that of " +
                      std::string(area_family_name(fit.family)) + " at alpha " + number(fit.alpha, 3) +
                      " takes its place, corrected at one direction for each piece of a light");
}

}  // namespace

Scene scene_of(SceneArguments& arguments, SceneNotes& notes) {
  Scene scene;
  std::tie(scene.width, scene.height) = size_of(arguments.size);
  const auto transfer = transfer_named(arguments.transfer);
  if (!transfer)
    throw Error::at("--transfer", printable(arguments.transfer),
                    "srgb, power-2.2, power-0.45, sqrt or linear");
  scene.transfer = *transfer;
  const auto tone = tone_named(arguments.tone);
  if (!tone)
    throw Error::at("--tone", printable(arguments.tone), "plain, neutral, agx-like, filament or false-color");
  scene.tone = *tone;
  scene.exposure = arguments.exposure;
  scene.shape = arguments.quad ? Shape::quad : Shape::sphere;
  scene.perspective = arguments.perspective;
  scene.field_of_view_deg = arguments.field_of_view;
  if (arguments.orbit != 0 || arguments.tilt != 0)
    scene.view = View{.turn_deg = arguments.orbit, .rise_deg = arguments.tilt};
  if (!arguments.background.empty())
    scene.background = vec(typed_color("--background", arguments.background));
  scene.surface = subject_surface(arguments, notes);
  // Where nothing is said, the texture is the emission itself.
  if (!arguments.emission_texture.empty()) scene.surface.emission = {1, 1, 1};
  if (!arguments.emission.empty()) scene.surface.emission = vec(typed_emission(arguments.emission));
  scene.surface.occlusion = arguments.occlusion;
  read_textures(arguments);
  scene.textures = arguments.textures;
  if (scene.textured().f0) scene.surface.curve.reset();  // F0 is that of the texels
  choose_models(scene, arguments.model, arguments.diffuse_model, typed_set(arguments.set), notes.remarks);
  if (const std::optional<int> count = light_count(arguments.lights)) {
    scene.lights.lights = spread_lights(*count);
    scene.lights.hemispheres.reset();
  } else if (arguments.lights == "sources") {
    scene.lights = default_lights();
  } else if (!arguments.lights.empty()) {
    scene.lights = parse_lights(read_file(arguments.lights), arguments.lights);
  } else if (arguments.environment.empty()) {
    scene.lights = arguments.standard_lights();
  }
  if (!arguments.environment.empty()) scene.lights.environment = arguments.environment;
  if (!arguments.ground.empty()) scene.lights.ground = vec(typed_share("--ground", arguments.ground));
  scene.lights = with_ground(scene.lights);
  scene.refined = arguments.refined;
  tell_areas(scene, notes.remarks);
  validate(scene);
  if (std::string text = ambient_remark(scene, held_by_textures(scene)); !text.empty())
    notes.remarks.push_back(std::move(text));
  return scene;
}

void add_subject_options(Command verb, SceneArguments& arguments) {
  verb.option(
          "SUBJECT", arguments.subject,
          "material (gold, gold/ID, a file), or a surface in numbers: f0=0.04 or f0=1,0.78,0.34, f82=, n=, k=, diffuse=, gloss=, roughness=, opacity=")
      .reads_file()
      .value_name("");
  verb.option("--dataset", arguments.dataset, "dataset of the material instead of the preferred one")
      .value_name("ID");
  verb.option("--set", arguments.set,
              "value of a model's parameter, NAME.r for one channel; may be given again")
      .value_name("NAME=NUMBER")
      .one_at_a_time();
  add_color_option(verb, "--diffuse", arguments.diffuse,
                   "diffuse colour, linear; conductors and semiconductors stay black");
  add_roughness_options(verb, arguments.rough, "of the surface");
  add_solver_options(verb, arguments.compute);
  add_table_options(verb, arguments.tables);
  add_library_options(verb, arguments.library);
}

void add_scene_options(Command verb, SceneArguments& arguments) {
  add_subject_options(verb, arguments);
  verb.option("--model", arguments.model,
              "specular model (see etak models), or none; default " + std::string(default_specular))
      .value_name("MODEL");
  verb.option("--diffuse-model", arguments.diffuse_model,
              "diffuse model, or none; default " + std::string(default_diffuse))
      .value_name("DIFFUSE_MODEL");
  verb.option("--opacity", arguments.opacity, "of the body, 0 to 1").show_default("1, of clear bodies 0");
  add_color_option(verb, "--emission", arguments.emission,
                   "radiance that the surface sends out by itself, linear; default black");
  verb.option("--occlusion", arguments.occlusion,
              "share of the light of hemispheres and environment that reaches the surface, 0 to 1")
      .show_default();
  verb.option(
          "--emission-texture", arguments.emission_texture,
          "picture of the emission, which multiplies --emission; codes are sRGB where the file does not say linear, and floats are linear")
      .reads_file()
      .value_name("FILE");
  verb.option("--occlusion-texture", arguments.occlusion_texture,
              "picture whose red or grey channel multiplies --occlusion, linear")
      .reads_file()
      .value_name("FILE");
  verb.option(
          "--lights", arguments.lights,
          "number of directional lights, a light setup, or sources: three lights and two hemispheres; default " +
              std::string(arguments.standard_lights == default_lights ? "sources"
                                                                      : "the studio and two flashes"))
      .reads_file()
      .value_name("N|FILE|sources");
  verb.option(
          "--env", arguments.environment,
          "environment: lat-long HDR or EXR picture, or etak's own: studio, rim, overcast, sunset or night; without --lights the only light")
      .reads_file()
      .value_name("FILE|NAME");
  add_color_option(verb, "--ground", arguments.ground,
                   "albedo of a level ground under the object, which lights it by one bounce; default none");
  verb.option("--size", arguments.size, "of the picture in pixels").value_name("N|WxH").show_default();
  verb.flag("--quad", arguments.quad, "a flat square instead of the sphere");
  verb.flag("--perspective", arguments.perspective, "perspective camera instead of an orthographic one");
  verb.option("--fov", arguments.field_of_view, "vertical field of view in degrees").show_default();
  verb.option("--orbit", arguments.orbit,
              "turn of the camera around the object, in degrees: at 90 it looks from the right")
      .range(-360.0, 360.0)
      .show_default();
  verb.option("--tilt", arguments.tilt,
              "height of the camera above the horizon, in degrees; a quad is seen at a grazing angle near 90")
      .range(-90.0, 90.0)
      .show_default();
  add_color_option(verb, "--background", arguments.background, "linear; default 0.18 grey");
  verb.option("--exposure", arguments.exposure, "linear factor").show_default();
  verb.option("--transfer", arguments.transfer, "display curve")
      .words({"srgb", "power-2.2", "power-0.45", "sqrt", "linear"})
      .show_default();
  verb.option("--tone", arguments.tone, "tone curve before --transfer; neutral is Khronos PBR Neutral")
      .words({"plain", "neutral", "agx-like", "filament", "false-color"})
      .show_default();
  verb.refuse("--space", "pictures and their lights are in linear sRGB",
              "etak f0 or etak export with --space, whose values are");
}

}  // namespace etak::cli
