// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/document/document.h"
#include "core/render/view_state.h"

namespace etak::editor {

/// Settings of the picture that belong to the window and not to the project: camera, separator, overlays.
struct Look {
  double separator = 0.5;
  bool zone_overlay = false, energy_overlay = false, angle_overlay = false, textured = true;
  bool in_blocks = false;  // textures of side A as BC7 holds them
  View camera;
  bool perspective = false;
  std::shared_ptr<const MeshShape> mesh;  // of the project's view; null until it has been loaded
  std::string photograph;                 // name of the photograph in place of side B; empty: none
  std::string engine;  // as which side A is shown (core/render/engines.h); empty: by its own models
  std::optional<ProjectMaterial> preview;  // a material of the library, shown in place of the current one
};

/// Two ways of looking. Look: the environment behind the object, blurred, a ground and a neutral tone curve, so that
/// materials look as in a room. Measure: a grey background and the plain sRGB curve, so that 18 % is code 118 and
/// each code is its number. Both leave shape, lights, exposure of Look and comparison as they are.
void take_look(ProjectView& view);
void take_measure(ProjectView& view);
bool is_look(const ProjectView& view);
bool is_measure(const ProjectView& view);

/// A project without materials, which is looked at as by take_look().
Project new_project();

/// The state of the viewport for the current material.
///   environment   the environment of the project's view; null until it has been loaded
///   textures      the textures of the current material; null until they have been loaded
///   in_blocks     these for side A, as blocks hold them; null: as they are
ViewState view_state_of(const Document& document, const Look& look,
                        std::shared_ptr<const Environment> environment,
                        std::shared_ptr<const SurfaceTextures> textures,
                        std::shared_ptr<const SurfaceTextures> in_blocks = nullptr);

}  // namespace etak::editor
