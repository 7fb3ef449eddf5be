// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/options.h"
#include "app/cli/options/roughness.h"
#include "core/render/scene.h"

namespace etak::cli {

/// What a picture shows, as typed.
struct SceneArguments {
  std::vector<std::string> subject;  // a material, or NAME=NUMBER[,NUMBER,NUMBER] of a surface made up
  std::string dataset;
  std::string model, diffuse_model;
  std::vector<std::string> set;
  std::vector<double> diffuse, background;
  RoughnessArguments rough;
  double opacity = 1, exposure = 1, field_of_view = 30;
  std::string lights, environment, tone = "plain", transfer = "srgb", size = "512";
  bool quad = false, perspective = false;
  LightSetup (*standard_lights)() = default_lights;  // where nothing is said
  Library library;
};
void add_scene_options(Command verb, SceneArguments& arguments);

/// Changes `arguments` do not say: what a surface is called, and values that had to be brought into a model's
/// range.
struct SceneNotes {
  std::string subject;
  std::vector<std::string> remarks;
};

/// Adds a remark where a roughness was given that Schueler's gloss does not hold, and what of the scene takes
/// that.
void tell_held_gloss(const Scene& scene, SceneNotes& notes);

/// The scene asked for. Throws Error that names the option or file.
Scene scene_of(SceneArguments& arguments, SceneNotes& notes);

/// A scene's models and their values: `specular` and `diffuse` by id ("" the default, "none" no such part),
/// then the values of --set. Hemispheres and environment then see the colours and gloss that were set.
void choose_models(Scene& scene, const std::string& specular, const std::string& diffuse,
                   const std::vector<std::pair<std::string, double>>& set, std::vector<std::string>& remarks);

}  // namespace etak::cli
