// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/render/ambient/lobe_fit.h"
#include "core/render/ambient/lobe_samples.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

/// How a surface reflects light from all around, computed from its models: what moving pictures take in place of the
/// integral of f_r nl over an environment or hemispheres (core/light/ambient.glsl). Its nodes lie at even steps of
/// sqrt(nv) from 0 to 1 and, where the gloss follows a texture, of gloss from 0 to 1; all between is linear.
///   albedo   three numbers a node: the directional albedo of the specular part for red, green and blue, right for any
///            form of F; with `of_f0` the coefficients of 1, F0 and F0^2, which are right at F0 of 0.04, 0.5 and 1
///   probes   three numbers a node for each round lobe that stands for a part of the model's: its tilt, 0 along the
///            normal and 1 along the mirrored viewer, its level, and its share
///   body     three numbers a view: the directional albedo of the diffuse part for a diffuse colour of 1
/// A table over gloss has fewer views, so that its numbers fit into the uniforms of any OpenGL ES 3.0 (224 vectors).
struct AmbientTable {
  int views = 24, glosses = 1;
  bool of_f0 = false;
  bool plain_body = true;  // the body's albedo is its colour at every view
  bool anisotropic =
      false;  // the lobe depends on how the surface is turned about its normal: round ones stand for it
  std::vector<float> albedo, body;
  std::array<std::vector<float>, probe_count> probes;
  LobeSamples samples;  // of a refined scene; they then stand for the lobe in place of the probes
};

/// Which of a surface's values textures hold.
struct Textured {
  bool f0 = false, gloss = false;
  friend bool operator==(const Textured&, const Textured&) = default;
};
Textured held_by_textures(const Scene& scene);

/// The formula that a scene's hemispheres have: never HemisphereForm::automatic.
HemisphereForm hemisphere_form(const Scene& scene);

/// The table of a scene's surface. The last ones are kept, so that a picture that only turns does not compute one.
/// Takes about a millisecond, six times that where the gloss follows a texture.
std::shared_ptr<const AmbientTable> ambient_table(const Scene& scene, const Textured& textured);

/// A refined scene without textures whose lobe is wide, with the bright part of its environment as lights; other scenes as they are.
Scene with_bright_lights(const Scene& scene, const Environment* environment, unsigned threads);

/// The values of a surface that its light from all around cannot follow, as a sentence; empty: none, or there is no such
/// light.
std::string ambient_remark(const Scene& scene, const Textured& textured);

}  // namespace etak
