// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/render/ambient/refined.h"
#include "core/render/glsl/glsl_text.h"

namespace etak {

/// The shader that sums the ambient light of a refined scene, a part of the samples a pass, and what it reads. It is
/// drawn `passes` times into a target of floats that begins black, each time with the next whole number as the uniform
/// ambient_pass; the results are added. The shader of glsl_text() then reads the sum, as the sampler ambient_picture.
struct GlslRefined {
  static constexpr int passes = 32;
  GlslText text;
  AmbientPlan plan;  // owns the samples
  std::vector<std::pair<std::string, const Image*>>
      textures;  // samplers, without those of the scene's textures
};
///   environment   null: none; it must live as long as the result is used
///   threads       for the form of the environment that is made when it is first refined
GlslRefined glsl_refined(const Scene& scene, const Environment* environment, unsigned threads);

}  // namespace etak
