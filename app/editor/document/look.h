// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/editor/document/document.h"
#include "core/render/view_state.h"

namespace etak::editor {

/// What of the picture belongs to the window and not to the project: camera, separator, overlays.
struct Look {
  double separator = 0.5;
  bool zone_overlay = false, energy_overlay = false, textured = true;
  View camera;
  std::optional<ProjectMaterial> preview;  // of the library, shown in place of the material in hand
};

/// The state of the viewport for the material in hand.
///   environment   of the project's view, when it has been loaded
///   textures      of the material in hand, when they have been loaded
ViewState view_state_of(const Document& document, const Look& look,
                        std::shared_ptr<const Environment> environment,
                        std::shared_ptr<const SurfaceTextures> textures);

}  // namespace etak::editor
