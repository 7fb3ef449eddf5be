// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/options/scene.h"
#include "app/cli/output/output.h"
#include "core/render/environment.h"

namespace etak::cli {

/// The options of `etak render`.
struct RenderArguments {
  SceneArguments scene;
  OutputArguments stats;  // of --format json, which goes to standard output
  std::string picture;    // -o
  std::string device = "auto";
  std::string ambient = "refined";
  std::string ocio, display, view;
  std::string as;            // an engine
  std::string mesh;          // a glTF file
  std::string sweep;         // NAME=VALUES
  std::string part = "all";  // of the sheet: see draw_sheet()
  bool reference = false, sheet = false, half = false, transparent = false;
  int samples = 16, light_samples = 16, frames = 1, turntable = 1;
  unsigned threads = 0;
};

/// The light from all around of a scene: null, one of etak's studios, or a picture's. Throws Error.
std::shared_ptr<const Environment> environment_of(const Scene& scene, unsigned threads);

/// The file of the picture, or those of all pictures of a turntable.
std::vector<std::string> files_of(const RenderArguments& arguments);

/// Throws Error for files that cannot be written, and for options that do not stand beside each other.
void check_picture_name(const RenderArguments& arguments);

/// Does the work of the verb, in the module of pictures.h. Returns the exit status; throws Error.
int draw(RenderArguments& arguments);

}  // namespace etak::cli
