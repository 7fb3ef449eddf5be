// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/render/scene.h"

namespace etak::test {

/// A scene with everything on: `model` (and Lambert where it is specular alone), lights of all kinds,
/// hemispheres, environment, transparency, exposure. Parameters at their initial values, diffuse colours at
/// 0.5.
Scene full_scene(const Model& model);

/// The same with nothing but the model and one directional light.
Scene bare_scene(const Model& model);

/// Named variants of a model's scene: everything on, everything off, each feature toggled alone from both.
struct Variant {
  std::string name;
  Scene scene;
};
std::vector<Variant> variants(const Model& model);

/// What a command prints, with its errors, and its status as the C library gives it.
std::pair<std::string, int> run(const std::string& command);

}  // namespace etak::test
