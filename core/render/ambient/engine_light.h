// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "core/math/mat3.h"

namespace etak {

/// What an engine reflects of even light from all around. It sees the environment along the mirrored viewer through one round
/// lobe of its roughness (Karis 2013, "split sum"), and multiplies it by `specular`.
///   specular   the engine's albedo of the surface, for each channel
///   body       share of the diffuse colour; none: the integral of its model
struct EngineLight {
  Vec3 specular{};
  std::optional<Vec3> body;
};

/// The ambient term that an engine publishes; nullopt for models that are none of an engine, and for those of engines that
/// sample their model (Cycles).
///   model   "as-unreal"
///   nv      cosine of normal and viewer, (0, 1]
///   alpha   width of the lobe, (0, 1]
std::optional<EngineLight> engine_light(std::string_view model, double nv, double alpha, const Vec3& f0);

}  // namespace etak
