// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

/// How many samples of each part of a surface a refined picture has where nothing else is asked for.
inline constexpr int refined_samples = 128;

/// Whether hemispheres and environment of the scene are integrated by samples. Hemispheres of the printed form are
/// drawn by their term always, since nobody asks for that form but to see it.
bool is_refined(const Scene& scene, bool has_environment);

/// How the ambient light of a refined scene is sampled, by the CPU and by OpenGL alike: the model's lobe by half
/// vectors that follow it (LobeDensity), a diffuse part that is not flat by the cosine. The weight of a sample is
/// f nl over its density with f of the model's own text, and its light is the mean over the solid angle that it
/// stands for.
struct AmbientPlan {
  // The specular part: the model, with black diffuse colours. Null: none.
  const Model* specular = nullptr;
  std::vector<double> specular_values;

  // The diffuse part: the diffuse model, or what the values of a model of kind both add to `specular_values`. A flat
  // one has the same f_r for all directions, as Lambert's, so that the irradiance alone counts.
  enum class Body { none, flat, sampled };
  Body body = Body::none;
  const Model* diffuse = nullptr;
  std::vector<double> diffuse_values;
  Vec3 flat{};            // f_r of a flat body; where textures give its colour, that of a white one
  bool combined = false;  // `diffuse` is `specular`

  // Whether samples of the lobe see the dim part of an environment alone, and the bright part comes as lights. It does
  // so for the samples of a body always.
  bool wide = false;

  // A row for each set of samples, a column for each sample: first, the directions of the light by the cosine, then
  // half vectors for the lobe of the surface or, where a texture holds gloss, for lobe_rows lobes from gloss 0 to 1.
  // Channels: the unit vector in the frame of the surface, and a weight.
  //   solid angle of a sample   the weight, times lh for half vectors
  Image samples;
  static constexpr int lobe_rows = 33;
};

/// Throws Error for a scene without models.
AmbientPlan ambient_plan(const Scene& scene);

}  // namespace etak
