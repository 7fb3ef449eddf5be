// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/options.h"
#include "core/render/typed.h"

namespace etak::cli {

/// The options that say what a picture or a curve shows.
struct SceneArguments {
  std::vector<std::string> subject;  // a material, or a surface in numbers: NAME=NUMBER[,NUMBER,NUMBER]
  std::string dataset;
  TableSettings tables;
  F0Settings compute;
  std::string model, diffuse_model;
  std::vector<std::string> set;
  std::string diffuse, background;  // colours as typed
  RoughnessArguments rough;
  std::string emission, ground;  // colours as typed
  double occlusion = 1;
  std::string texture, gloss_texture;  // files: diffuse colour and opacity; F0 and gloss
  std::string emission_texture, occlusion_texture;
  std::shared_ptr<const SurfaceTextures> textures;  // what these files hold; null before read_textures()
  bool refined = false;                             // as in struct Scene
  std::optional<double> opacity;                    // none: 1, and 0 of clear bodies
  double exposure = 1, field_of_view = 30;
  std::string lights, environment, tone = "plain", transfer = "srgb", size = "512";
  bool quad = false, perspective = false;
  double orbit = 0, tilt = 0;  // degrees, of the camera around the object and above the horizon
  LightSetup (*standard_lights)() = default_lights;  // where nothing is said
  Library library;
};
void add_scene_options(Command verb, SceneArguments& arguments);

/// Reads the textures, if that has not been done. Throws Error that names the file.
void read_textures(SceneArguments& arguments);

/// Those of them that say what the surface is made of: SUBJECT, --dataset, --set, --diffuse, the roughness, and
/// how F0 is computed.
void add_subject_options(Command verb, SceneArguments& arguments);

/// The name of the surface, and remarks for the user, such as values that were clamped to the range of a
/// model.
struct SceneNotes {
  std::string subject;
  std::vector<std::string> remarks;
};

/// Adds a remark where the user gave a roughness that Schueler's gloss cannot hold. It names the models and
/// lights of the scene that use the gloss.
void tell_held_gloss(const Scene& scene, SceneNotes& notes);

/// The scene that the options describe. Throws Error that names the option or file.
Scene scene_of(SceneArguments& arguments, SceneNotes& notes);

/// The material that the subject names.
struct SubjectMaterial {
  Material material;
  std::size_t at = 0;  // of its dataset
  const Dataset& dataset() const { return material.datasets[at]; }
};

/// Whether the subject is a surface in numbers instead.
bool is_typed(const SceneArguments& arguments);

/// Throws Error where the subject is no one material. `notes` gets its name and remarks on the name as typed.
SubjectMaterial subject_material(SceneArguments& arguments, SceneNotes& notes);

/// The surface that the subject names or gives in numbers. Throws Error.
SurfaceValues subject_surface(SceneArguments& arguments, SceneNotes& notes);

/// What the options ask of a material's surface.
SurfaceWishes surface_wishes(const SceneArguments& arguments);

/// Chooses the models of a scene and their values. `set` may change the colours and the gloss of the surface
/// too; the light of hemispheres and environment then uses the changed values. Throws Error.
///   specular, diffuse   ids of models; empty: the default; "none": no such part
///   set                 names and values of --set
///   remarks             gets a line for every value that was clamped to the range of its parameter
void choose_models(Scene& scene, const std::string& specular, const std::string& diffuse,
                   const std::vector<std::pair<std::string, double>>& set, std::vector<std::string>& remarks);

}  // namespace etak::cli
