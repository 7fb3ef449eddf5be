// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/render/scene.h"
#include "core/render/sheet.h"
#include "core/render/view_state.h"

namespace etak {

class Environment;

/// An engine as its makers publish it: its model with mapping of roughness (core/brdf/engines), its light from all around
/// (core/render/ambient/engine_light.h) and its tone curve.
///   model         id of the model
///   tone          Tone::plain where the engine's own is not drawn
///   most_f0       of a dielectric, which its field holds
///   source        what the formulas are of
///   not_drawn     what the engine does not publish, or etak does not draw; empty: nothing
struct Engine {
  std::string_view id, title, model;
  Tone tone = Tone::plain;
  double most_f0 = 1;
  std::string_view source, not_drawn;
};
std::span<const Engine> engines();
const Engine* find_engine(std::string_view id);  // null: none
std::vector<std::string> engine_ids();

/// The surface with what the engine's fields hold of it: F0 of at most 1 or, of a dielectric, most_f0, and no curve over the
/// angle. A surface without a body whose luminance of F0 is in the forbidden zone or above is a metal.
///   changed   gets what did not fit
SurfaceValues held_by(const Engine& engine, SurfaceValues surface, std::vector<ClampedValue>& changed);

/// The scene as the engine shows it; its tone curve where the scene has none.
Scene shown_as(const Engine& engine, Scene scene, std::vector<ClampedValue>& changed);

/// A side of a viewport as the engine shows it.
ViewSide shown_as(const Engine& engine, ViewSide side);

/// The scene with the exact material: GGX, Fresnel's equations or the curve of its layers, Smith and light between facets, and
/// Lambert. Where F0 follows a texture, whose n and k nobody knows, Fresnel is Schlick's.
Scene exact_scene(Scene scene);

/// How far the engine is from the exact material, both through the engine's tone curve.
DifferencePicture engine_difference(const Engine& engine, const Scene& scene, const Environment* environment,
                                    unsigned threads);

}  // namespace etak
